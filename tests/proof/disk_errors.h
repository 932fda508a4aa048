/* SPDX-License-Identifier: MIT */
#define COR_PROOF_FAR 0x1p-80
#define COR_PROOF_SERIES (5.1 * 0x1p-53)
#define COR_PROOF_START 0x1p-48
#define COR_PROOF_FIRST_RESIDUAL 0.009
#define COR_PROOF_STEP 0x1p-44
#define COR_PROOF_NEWTON 0x1p-82
