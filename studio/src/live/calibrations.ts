import type { FaceCalibration } from 'furrow/three'
import { parseJson } from 'furrow-files'
import { bytesOf } from '../files/dropped-files.ts'

/** Prefix of keys of `localStorage`. The sender of the scores follows. */
const KEY = 'furrow-calibration-'

/** Returns the calibration for a sender of scores that was stored in this browser, unchecked, or null. */
export function storedCalibration(sender: string): FaceCalibration | null {
  try {
    return JSON.parse(localStorage.getItem(KEY + sender) ?? 'null')
  } catch {
    return null
  }
}

/** Stores the calibration for a sender, or removes it if null. Does nothing if the browser denies storage. */
export function storeCalibration(sender: string, calibration: FaceCalibration | null): void {
  try {
    if (calibration) localStorage.setItem(KEY + sender, JSON.stringify(calibration))
    else localStorage.removeItem(KEY + sender)
  } catch {}
}

/** Reads a calibration from a file, unchecked. Rejects with a FurrowError if the file is not JSON. */
export async function readCalibration(file: File): Promise<FaceCalibration> {
  return parseJson(await bytesOf(file, file.name), file.name, 'Studio') as FaceCalibration
}
