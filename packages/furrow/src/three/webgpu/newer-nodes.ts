/**
 * Functions of TSL that three.js r168 to r185 lack. A bundler refuses a named import of a missing export; read from the namespace they are
 * undefined, and `checkThree` names the release that is needed.
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
