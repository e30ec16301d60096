/**
 * TSL functions that three.js r168 to r185 lack. Read from the namespace, because bundlers reject named imports of missing exports.
 * `checkThree` reports the required release.
 */
import * as TSL from 'three/tsl'

export const instancedMesh = TSL.instancedMesh
export const localId = TSL.localId
export const negateOnBackSide = TSL.negateOnBackSide
export const OnBeforeObjectUpdate = TSL.OnBeforeObjectUpdate
export const sRGBTransferEOTF = TSL.sRGBTransferEOTF
export const subBuild = TSL.subBuild
export const workgroupArray = TSL.workgroupArray
export const workgroupBarrier = TSL.workgroupBarrier
export const workgroupId = TSL.workgroupId
