import { checkWrinkles, decodeGlb, documentOf, type Finding, VALIDATOR_FAILED } from 'furrow-files'
import { beforeAll, describe, expect, it } from 'vitest'
import type { DocumentToPack } from '../../studio/src/document/packed-layers.ts'
import { exportDocument } from '../../studio/src/export/export-document.ts'
import { exportDocumentInWorker, readProjectInWorker } from '../../studio/src/export/in-worker.ts'
import { readDocument } from '../../studio/src/export/read-document.ts'
import { readFace } from '../../studio/src/export/read-face.ts'
import { findingsOf } from '../../studio/src/export/validate-face.ts'
import { type FaceFiles, openFace } from '../../studio/src/files/face-files.ts'
import type { DamagedFace } from './damaged-faces.ts'
import type { EncodedFiles, ExportCase, ExportCases, InvalidFace } from './export-cases.ts'

const IS_WEBKIT = /^(?!.*Chrome).*AppleWebKit/.test(navigator.userAgent)

let project: Map<string, Uint8Array>
/** Studio document of the project, which has no strokes. */
let source: DocumentToPack
let cases: ExportCase[]
let invalid: InvalidFace[]

beforeAll(async () => {
  const made: ExportCases = await (await fetch('/export-cases.json')).json()
  project = decoded(made.project)
  const list = [...project].map(([path, bytes]) => ({ path, file: new File([bytes as BlobPart], path) }))
  const { document } = await readProjectInWorker({ name: 'project', files: list })
  source = { document, drawn: new Map() }
  cases = made.cases
  invalid = made.invalid
})

describe("the studio's export", () => {
  it('writes the bytes of furrow pack and reports the findings of furrow validate', async () => {
    expect(cases.length).toBe(9)
    for (const { name, face, files, options, packed, findings } of cases) {
      const exported = await exportDocument(faceOf(face, files), source, options)
      expect(same(exported.bytes, bytesOf(packed)), name).toBe(true)
      expect(exported.findings, name).toEqual(findings)
      expect(exported.warnings.join(), name).toMatch(
        /target "missing".* does not exist; the reference to it is kept/,
      )
      expect(exported.cost.file, name).toBeLessThan(exported.bytes.length)
      expect(exported.cost.gpu, name).toBeGreaterThan(16 * 16)
    }
  })

  it('writes back an unchanged face byte for byte', async () => {
    for (const { name, packed, options } of cases) {
      if (options.ktx2) continue
      const bytes = bytesOf(packed)
      const { face } = await readFace({ name: 'face.glb', bytes })
      const document = (await readDocument({ name: 'face.glb', bytes }))!
      const exported = await exportDocument({ name: 'face.glb', bytes: face }, { document, drawn: new Map() })
      expect(same(exported.bytes, bytes), name).toBe(true)
    }
  })

  it('reports progress, and stops when aborted', async () => {
    const [{ face, files }] = cases
    const steps: string[] = []
    const onProgress = (...step: number[]) => steps.push(step.join('/'))
    await exportDocumentInWorker(faceOf(face, files), source, {}, { onProgress })
    expect(steps).toEqual(['1/7', '2/7', '3/7', '4/7', '5/7', '6/7', '7/7'])
    const stop = new AbortController()
    const stopped = exportDocumentInWorker(faceOf(face, files), source, {}, { signal: stop.signal })
    stop.abort(new Error('changed her mind'))
    await expect(stopped).rejects.toThrow('changed her mind')
  })

  it('refuses unusable input and says why', async () => {
    const [glb, , , , , , gltf] = cases
    const face = faceOf(glb.face, glb.files)
    const { document } = source
    const withNormal = (bytes: Uint8Array) => {
      const [first, ...others] = document.layers
      const maps = { ...first.maps, normal: { mimeType: 'image/png', bytes } }
      return { document: { ...document, layers: [{ ...first, maps }, ...others] }, drawn: new Map() }
    }
    const cut = project.get('layers/age/normal.png')!.subarray(0, 60)
    await expect(exportDocument(face, withNormal(cut))).rejects.toThrow(
      'Studio: cannot read the image normal of age (truncated file)',
    )
    const bare = { ...document, areas: [], drivers: [] }
    await expect(exportDocument(face, { document: bare, drawn: new Map() })).rejects.toThrow(
      'Studio: the document has no areas',
    )
    const alone = { name: 'parts.gltf', bytes: bytesOf(gltf.files['parts.gltf']) }
    await expect(exportDocument(alone, source)).rejects.toThrow(
      /Studio: cannot read parts.*referenced by parts.gltf/,
    )
  })
})

it('decodes a Draco face in the browser', async () => {
  const read = async (name: string) => {
    const file = new Uint8Array(await (await fetch(`/packed/${name}.glb`)).arrayBuffer())
    const document = await documentOf(decodeGlb(file, name, 'test'), name, 'test')
    const [primitive] = document.getRoot().listMeshes()[0].listPrimitives()
    return [primitive.getIndices()!.getCount(), primitive.listTargets().length]
  }
  expect(await read('draco')).toEqual(await read('images'))
})

describe("the studio's validation", () => {
  it('agrees with furrow validate on intact and damaged files of all formats', async () => {
    const faces: DamagedFace[] = await (await fetch('/damaged-faces.json')).json()
    const differing: string[] = []
    for (const { name, file, problem, isUnsure } of faces) {
      const findings = await checkWrinkles(decodeGlb(bytesOf(file), 'face.glb', 'test'))
      const error = findings.find(({ severity }) => severity === 'error')
      // WebKit decodes damaged JPEG and WebP images in part, without an error.
      const isShown = IS_WEBKIT && /webp|jpeg/.test(name) && !error
      if (Boolean(error) !== (problem !== null) && !isUnsure && !isShown)
        differing.push(`${name}: ${problem}; here: ${error?.message}`)
    }
    expect(differing).toEqual([])
  })

  it('reports the findings of furrow validate in the same words', async () => {
    for (const { name, file, findings } of invalid) {
      const found = await validate({ name: 'face.glb', bytes: bytesOf(file) })
      // The texts of errors thrown inside the Khronos validator depend on the JavaScript engine.
      const own = ({ code, message, ...rest }: Finding) => ({
        code,
        ...rest,
        ...(code !== VALIDATOR_FAILED && { message }),
      })
      expect(found.map(own), name).toEqual(findings.map(own))
      expect(found.some(({ severity }) => severity === 'error')).toBe(true)
    }
  })

  it('accepts faces without wrinkles, and says why it refuses other files', async () => {
    const [{ packed }] = cases
    const { face } = await readFace({ name: 'face.glb', bytes: bytesOf(packed) })
    const findings = await validate({ name: 'face.glb', bytes: face })
    expect(findings[0]).toMatchObject({ severity: 'warning', code: 'NO_WRINKLES' })
    const picture = { name: 'face.glb', bytes: project.get('areas/brow.png')! }
    await expect(validate(picture)).rejects.toThrow('Studio: face.glb is not usable: it is an image')
  })
})

const validate = async (face: FaceFiles) => findingsOf(await openFace(face, 'Studio'))

function faceOf(name: string, files: EncodedFiles) {
  const references = decoded(files)
  return { name, bytes: references.get(name)!, references }
}

function decoded(files: EncodedFiles): Map<string, Uint8Array> {
  return new Map(Object.entries(files).map(([path, text]) => [path, bytesOf(text)]))
}

function bytesOf(base64: string): Uint8Array {
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))
}

function same(a: Uint8Array, b: Uint8Array): boolean {
  return a.length === b.length && a.every((byte, i) => byte === b[i])
}
