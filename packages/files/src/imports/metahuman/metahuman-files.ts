import { FurrowError, type GrayImage } from 'furrow'
import { resampleGray } from 'furrow/internal'
import { channelOf, type Pixels } from '../../images/pixels.ts'
import { isImagePath, type SourceFiles, stemOf } from '../source-files.ts'
import { readSourceImage } from '../source-image.ts'
import { CURVES, type WrinkleCurve } from './curves.ts'

/** Paths of the animated maps by number, 1 to 3. */
export interface AnimatedMaps {
  normals: ReadonlyMap<number, string>
  colours: ReadonlyMap<number, string>
}

/**
 * Finds the animated maps by the names of the DCC export (`Head_Normal_Animated_WM1`), of Unreal's assets (`T_Face_Normal_Animated_WM1`) and of
 * older exports (`head_wm1_normal_map`, `FaceNormal_WM1`).
 */
export function animatedMaps({ paths }: SourceFiles): AnimatedMaps {
  const find = (word: string, prefix: string) => {
    const found = new Map<number, string>()
    for (const path of paths.filter(isImagePath)) {
      const stem = stemOf(path)
      const [, number] = new RegExp(`(?:^|_)${prefix}([123])(?:_|$)`).exec(stem) ?? []
      if (number !== undefined && stem.includes(word) && !found.has(Number(number)))
        found.set(Number(number), path)
    }
    return found
  }
  return { normals: find('normal', 'wm'), colours: find('color', 'cm') }
}

/** Reads masks. Each file is decoded once. */
export class MaskReader {
  readonly #files: SourceFiles
  readonly #who: string
  readonly #known = new Map<string, Promise<Pixels>>()

  constructor(files: SourceFiles, who: string) {
    this.#files = files
    this.#who = who
  }

  /**
   * Returns the mask of a curve.
   *
   * @throws FurrowError if it is missing or damaged.
   */
  async read({ file, channel, single }: WrinkleCurve, size: number): Promise<GrayImage> {
    const packed = this.#pathOf(new RegExp(`^(t_)?${file}a?$`, 'i'))
    const own = packed ?? this.#pathOf(new RegExp(`^(t_)?${single}$`, 'i'))
    if (own === undefined) throw missingMask(this.#files, file, this.#who)
    const pixels = this.#known.get(own) ?? readSourceImage(this.#files, own, this.#who)
    this.#known.set(own, pixels)
    return resampleGray(channelOf(await pixels, packed === undefined ? 0 : channel), size)
  }

  #pathOf(pattern: RegExp): string | undefined {
    return this.#files.paths.find((path) => isImagePath(path) && pattern.test(stemOf(path)))
  }
}

/** Lists the images that the import does not use, and the DNA files. */
export function unreadFiles({ paths }: SourceFiles, { normals, colours }: AnimatedMaps): string[] {
  const used = new Set([...normals.values(), ...colours.values()])
  const masks = CURVES.flatMap(({ file, single }) => [file, `${file}a`, single]).map((name) =>
    name.toLowerCase(),
  )
  return paths.filter((path) => {
    const isFile = /\.[^./]+$/.test(path)
    const isMask = masks.includes(stemOf(path).replace(/^t_/, ''))
    return isFile && !used.has(path) && !isMask
  })
}

function missingMask({ name }: SourceFiles, file: string, who: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: `the mask ${file} is missing in ${name}`,
    limit: [...new Set(CURVES.map((curve) => curve.file))].join(', '),
    remedy:
      'export the textures T_head_wm*_msk_* from Unreal, or use the DCC export, which has them in Masks',
  })
}
