import { fileURLToPath } from 'node:url'
import { canonicalTargetName } from 'furrow/internal'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { shapeFields } from '../../packages/furrow/src/author/shapes/fields/shape-fields.ts'
import { faceFrame } from '../../packages/furrow/src/author/shapes/landmarks/face-frame.ts'
import { movingSurface } from '../../packages/furrow/src/author/shapes/landmarks/moving-surface.ts'
import { encodeHead } from '../../packages/furrow/src/author/shapes/templates/template-code.ts'
import {
  meanHead,
  type TemplateHead,
  templateHead,
} from '../../packages/furrow/src/author/shapes/templates/templates.ts'

const fromRoot = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url))

/** For each head of the template table, the faces that are averaged. The blendshapes of these faces have ARKit's names. */
export const TEMPLATE_FACES: Readonly<Record<string, readonly string[]>> = {
  builder: ['faces/human.glb', 'faces/human-2.glb'].map(fromRoot),
  scan: [fromRoot('../shared/real-face/ict-face.glb')],
}

/** Reads the blendshapes of a face as templates for shape recognition. */
export async function readTemplateHead(path: string): Promise<TemplateHead> {
  const { skin } = findSkin(await readDocument(path, 'shape templates'), path, 'shape templates')
  const surface = movingSurface(skin)
  const frame = surface && faceFrame(surface)
  if (!frame) throw new Error(`shape templates: missing face, got none in ${path}`)
  const names = skin.targets.map(({ name }) => canonicalTargetName(name))
  return templateHead(shapeFields(surface, frame), names)
}

/** Averages the templates of some faces, and encodes the result as base64. */
export async function templateText(faces: readonly string[]): Promise<string> {
  const heads = await Promise.all(faces.map(readTemplateHead))
  return Buffer.from(encodeHead(meanHead(heads))).toString('base64')
}

/** Licence of the scanned face. The file with its templates must repeat the licence. */
export const SCAN_LICENCE = [
  'MIT License',
  '',
  'Copyright (c) 2020 USC Institute for Creative Technologies',
  '',
  'Permission is hereby granted, free of charge, to any person obtaining a copy',
  'of this software and associated documentation files (the "Software"), to deal',
  'in the Software without restriction, including without limitation the rights',
  'to use, copy, modify, merge, publish, distribute, sublicense, and/or sell',
  'copies of the Software, and to permit persons to whom the Software is',
  'furnished to do so, subject to the following conditions:',
  '',
  'The above copyright notice and this permission notice shall be included in all',
  'copies or substantial portions of the Software.',
  '',
  'THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR',
  'IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,',
  'FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE',
  'AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER',
  'LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,',
  'OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE',
  'SOFTWARE.',
]
