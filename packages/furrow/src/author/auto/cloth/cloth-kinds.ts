/** Kinds of cloth, which differ in stiffness. */
export const CLOTH_KINDS = ['silk', 'shirt', 'denim', 'leather'] as const
/** Kind of cloth: silk is the softest, leather the stiffest. */
export type ClothKind = (typeof CLOTH_KINDS)[number]

/** How a cloth folds. Lengths are in millimetres. */
export interface ClothProperties {
  /** Distance between folds. Stiffer cloth has wider folds. */
  wavelength: number
  /** Standard deviation of the diffusion of skin weights, in radii of the tube: how far cloth slides along a limb. */
  looseness: number
}

/** Wavelengths of folds: Rohmer et al. 2010 use 15 to 80 mm for garments from silk to leather. */
export const CLOTHS: Readonly<Record<ClothKind, ClothProperties>> = {
  silk: { wavelength: 19, looseness: 1.05 },
  shirt: { wavelength: 29, looseness: 1 },
  denim: { wavelength: 40, looseness: 0.9 },
  leather: { wavelength: 54, looseness: 0.8 },
}
