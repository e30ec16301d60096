/**
 * TSL functions that three.js r168 to r185 do not have. They are read from the namespace `TSL`, because bundlers reject a named import of a
 * missing export. With an older release they are undefined, and `checkThree` throws an error that names the required release.
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
