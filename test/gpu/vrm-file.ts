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

/** `wrinkledFile` as a VRM 1.0 whose face has MToon, with an outline or without. */
export function vrmFile(
  hasOutline: boolean,
  edit?: Parameters<typeof wrinkledFile>[0],
): Promise<Uint8Array<ArrayBuffer>> {
  return wrinkledFile(edit, (json) => {
    const mtoon = {
      specVersion: '1.0',
      shadeColorFactor: [0.7, 0.4, 0.4],
      ...(hasOutline && OUTLINE),
    }
    for (const material of json.materials) material.extensions.VRMC_materials_mtoon = mtoon
    const first = json.nodes.length
    json.nodes.push(...BONES.map((name) => ({ name })))
    json.scenes[0].nodes.push(...BONES.map((_, i) => first + i))
    json.extensionsUsed.push('VRMC_vrm', 'VRMC_materials_mtoon')
    const humanBones = Object.fromEntries(BONES.map((name, i) => [name, { node: first + i }]))
    const meta = { name: 'face', authors: ['nobody'], licenseUrl: 'https://vrm.dev/licenses/1.0/' }
    json.extensions = { VRMC_vrm: { specVersion: '1.0', meta, humanoid: { humanBones } } }
  })
}
