import { displayName } from '../display-name.ts'
import { jointRegionLabel } from './joints.ts'

/** Everyday names of the regions, by their names in files without the side. */
const REGION_NAMES: Readonly<Record<string, string>> = {
  brow: 'Brow',
  forehead: 'Forehead',
  foreheadInner: 'Inner forehead',
  foreheadOuter: 'Outer forehead',
  glabella: 'Between the brows',
  noseRoot: 'Bridge of the nose',
  nose: 'Nose',
  crowsFeet: 'Crow’s feet',
  underEye: 'Under the eye',
  nasolabial: 'Smile line',
  mouthCorner: 'Corner of the mouth',
  upperLip: 'Upper lip',
  lowerLip: 'Lower lip',
  chin: 'Chin',
  neck: 'Neck',
  bag: 'Bag under the eye',
  hood: 'Upper eyelid',
  cheek: 'Cheek',
  jowl: 'Jowl',
  paleLips: 'Pale lips',
}

/** Everyday names of ARKit's blendshapes, by their names without the side. */
const BLENDSHAPE_NAMES: Readonly<Record<string, string>> = {
  browDown: 'Brow lowered',
  browInnerUp: 'Inner brows raised',
  browOuterUp: 'Outer brow raised',
  cheekPuff: 'Cheeks puffed',
  cheekSquint: 'Cheek raised',
  eyeBlink: 'Eye closed',
  eyeLookDown: 'Eye looks down',
  eyeLookIn: 'Eye looks inwards',
  eyeLookOut: 'Eye looks outwards',
  eyeLookUp: 'Eye looks up',
  eyeSquint: 'Eye squinted',
  eyeWide: 'Eye wide open',
  jawForward: 'Jaw forward',
  jawLeft: 'Jaw to the left',
  jawOpen: 'Jaw open',
  jawRight: 'Jaw to the right',
  mouthClose: 'Lips closed',
  mouthDimple: 'Mouth corner pulled back',
  mouthFrown: 'Mouth corner lowered',
  mouthFunnel: 'Lips funnelled',
  mouthLeft: 'Mouth to the left',
  mouthLowerDown: 'Lower lip lowered',
  mouthPress: 'Lips pressed',
  mouthPucker: 'Lips puckered',
  mouthRight: 'Mouth to the right',
  mouthRollLower: 'Lower lip rolled in',
  mouthRollUpper: 'Upper lip rolled in',
  mouthShrugLower: 'Chin raised',
  mouthShrugUpper: 'Upper lip pushed up',
  mouthSmile: 'Smile',
  mouthStretch: 'Mouth stretched',
  mouthUpperUp: 'Upper lip raised',
  noseSneer: 'Nose wrinkled',
  tongueOut: 'Tongue out',
}

/** Returns the everyday name of a region without its side: `Inner forehead` for `foreheadInner`. */
export function regionName(stem: string): string {
  if (REGION_NAMES[stem]) return REGION_NAMES[stem]
  const flushed = stem.match(/^flush(.+)$/)?.[1]
  return flushed ? `Redness: ${regionName(lowered(flushed)).toLowerCase()}` : displayName(stem)
}

/** Returns the everyday name of a region: `Inner forehead, left` for `foreheadInnerLeft`. */
export function regionLabel(name: string): string {
  const ofJoint = jointRegionLabel(name)
  if (ofJoint) return ofJoint
  const [stem, side] = splitSide(name)
  return side ? `${regionName(stem)}, ${side.toLowerCase()}` : regionName(name)
}

/** Returns the everyday name of a blendshape: `Brow lowered, left` for `browDownLeft`. */
export function blendshapeLabel(name: string): string {
  const [stem, side] = splitSide(name)
  if (BLENDSHAPE_NAMES[name]) return BLENDSHAPE_NAMES[name]
  return BLENDSHAPE_NAMES[stem] ? `${BLENDSHAPE_NAMES[stem]}, ${side.toLowerCase()}` : displayName(name)
}

/** Returns the label of an expression: `Left brow` for `leftBrow`. */
export function expressionLabel(name: string): string {
  return displayName(name)
}

/** Returns the label of a joint, a muscle or a number: `Left arm` for `leftArm`. */
export function nameLabel(name: string): string {
  return displayName(name)
}

/** Splits a region's name into the name without its side, and the side. */
function splitSide(name: string): [stem: string, side: string] {
  const side = name.match(/(?<=.)(Left|Right)$/)?.[0] ?? ''
  return [name.slice(0, name.length - side.length), side]
}

function lowered(name: string): string {
  return name[0].toLowerCase() + name.slice(1)
}
