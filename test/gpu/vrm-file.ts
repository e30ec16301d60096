import { editGlb } from '../glb.ts'
import { wrinkledFile } from './wrinkled-file.ts'

/** The bones that VRM 1.0 requires. */
const BONES = [
  'hips',
  'spine',
  'head',
  ...['left', 'right'].flatMap((side) =>
    ['UpperLeg', 'LowerLeg', 'Foot', 'UpperArm', 'LowerArm', 'Hand'].map((bone) => side + bone),
  ),
]

const OUTLINE = { outlineWidthMode: 'worldCoordinates', outlineWidthFactor: 0.01 }

/**
 * `wrinkledFile` as a VRM 1.0 whose face has MToon, with an outline or without.
 *
 * @param change changes the JSON of the whole file.
 */
export async function vrmFile(
  hasOutline: boolean,
  edit?: Parameters<typeof wrinkledFile>[0],
  change?: Parameters<typeof asVrm>[1],
): Promise<Uint8Array<ArrayBuffer>> {
  return asVrm(await wrinkledFile(edit), (json) => {
    const mtoon = {
      specVersion: '1.0',
      shadeColorFactor: [0.7, 0.4, 0.4],
      ...(hasOutline && OUTLINE),
    }
    for (const material of json.materials) material.extensions.VRMC_materials_mtoon = mtoon
    json.extensionsUsed.push('VRMC_materials_mtoon')
    change?.(json)
  })
}

/** A file as a VRM 1.0, whose JSON may be changed further. */
export function asVrm(
  file: Uint8Array,
  change: Parameters<typeof editGlb>[1] = () => {},
): Uint8Array<ArrayBuffer> {
  return editGlb(file, (json) => {
    const first = json.nodes.length
    json.nodes.push(...BONES.map((name) => ({ name })))
    json.scenes[0].nodes.push(...BONES.map((_, i) => first + i))
    json.extensionsUsed = [...(json.extensionsUsed ?? []), 'VRMC_vrm']
    const humanBones = Object.fromEntries(BONES.map((name, i) => [name, { node: first + i }]))
    const meta = { name: 'face', authors: ['nobody'], licenseUrl: 'https://vrm.dev/licenses/1.0/' }
    json.extensions = { VRMC_vrm: { specVersion: '1.0', meta, humanoid: { humanBones } } }
    change(json)
  })
}
