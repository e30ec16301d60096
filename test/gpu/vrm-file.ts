import { addMToon, asVrm1 } from '../vrm.ts'
import { wrinkledFile } from './wrinkled-file.ts'

/**
 * Makes a VRM 1.0 from `wrinkledFile`, with MToon materials, optionally with an outline.
 *
 * @param change edits the complete JSON.
 */
export async function vrmFile(
  hasOutline: boolean,
  edit?: Parameters<typeof wrinkledFile>[0],
  change?: Parameters<typeof asVrm1>[1],
): Promise<Uint8Array<ArrayBuffer>> {
  return asVrm1(await wrinkledFile(edit), (json) => {
    addMToon(json, hasOutline)
    change?.(json)
  })
}
