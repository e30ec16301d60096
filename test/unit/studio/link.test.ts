import fc from 'fast-check'
import { AUTO_REGIONS } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { formatLink, type Link, parseLink } from '../../../studio/src/link/link.ts'

const PAGE = 'https://studio.example/furrow/?renderer=webgpu#old'

const fullLink: Link = {
  model: 'https://models.example/a%20face.glb?version=2&raw=1',
  pose: new Map([
    ['browInnerUp', 0.5],
    ['a:b,c&d=e/ä', 0.125],
  ]),
  camera: [0.1, 1.6, 0.55, 0, 1.62, 0],
  light: { yaw: -46, pitch: 20 },
  auto: {
    age: 63,
    strength: 1.25,
    size: 2048,
    seed: 7,
    regions: ['glabella', 'chin'],
    seeds: { chin: 9 },
    strengths: { crowsFeetLeft: 0.5 },
    densities: { nose: 1.5 },
    symmetry: 0.35,
  },
}

describe('a link', () => {
  it('is read as the values that it was made from', () => {
    expect(parseLink(`#${formatLink(fullLink, PAGE)}`, PAGE)).toEqual(fullLink)
  })

  it('is short: a model of this site is a path, and weights of 0 are left out', () => {
    const model = 'https://studio.example/furrow/faces/human.glb'
    const pose = new Map([
      ['jawOpen', 0.25],
      ['mouthClose', 0],
    ])
    const auto = { strength: 1, size: 1024, seed: 1 }
    const hash = formatLink({ model, pose, auto }, PAGE)
    expect(hash).toBe('model=faces/human.glb&pose=jawOpen:0.25&auto=,1,1024,1')
    expect(parseLink(hash, PAGE)).toEqual({
      model,
      pose: new Map([['jawOpen', 0.25]]),
      camera: undefined,
      light: undefined,
      auto,
    })
  })

  it('of a face at rest has an empty pose', () => {
    expect(formatLink({ pose: new Map() }, PAGE)).toBe('pose=')
    expect(parseLink('pose=', PAGE).pose).toEqual(new Map())
  })

  it('may have unknown parts, which are ignored', () => {
    expect(parseLink('#look=new&top', PAGE)).toEqual(parseLink('', PAGE))
  })

  it.each([
    ['another protocol', 'model=javascript:alert(1)'],
    ['data in the place of an address', 'model=data:model/gltf-binary,x'],
    ['a file of the disk', 'model=file:///etc/passwd'],
    ['a page that is not secure', 'model=http://models.example/a.glb'],
    ['a password', 'model=https://me:secret@models.example/a.glb'],
    ['no address', 'model=https://'],
    ['an address without end', `model=https://models.example/${'a'.repeat(3000)}`],
    ['an escape that is cut off', 'model=%E0%A4%A'],
    ['a weight above 1', 'pose=jawOpen:1.5'],
    ['a weight below 0', 'pose=jawOpen:-1'],
    ['a weight that is none', 'pose=jawOpen:NaN'],
    ['no weight', 'pose=jawOpen'],
    ['no name', 'pose=:1'],
    ['a name without end', `pose=${'a'.repeat(200)}:1`],
    ['blendshapes without end', `pose=${Array(600).fill('a:1').join()}`],
    ['five numbers of a camera', 'camera=1,2,3,4,5'],
    ['a light from behind', 'light=120,0'],
    ['one number of a light', 'light=20'],
    ['three numbers of a light', 'light=20,20,1'],
    ['an infinite camera', 'camera=Infinity,0,0,0,0,0'],
    ['a camera in what it looks at', 'camera=1,2,3,1,2,3'],
    ['a camera straight above', 'camera=0,9,0,0,0,0'],
    ['an age of 200', 'auto=200,1,1024,1'],
    ['a strength below 0', 'auto=45,-1,1024,1'],
    ['a size that would take the memory', 'auto=45,1,65536,1'],
    ['a size between', 'auto=45,1,1000,1'],
    ['a broken seed', 'auto=45,1,1024,0.5'],
    ['a broken seed of a region', 'auto=45,1,1024,1&lines=chin:0.5'],
    ['no seed of a region', 'auto=45,1,1024,1&lines=chin'],
    ['a symmetry above 1', 'auto=45,1,1024,1&symmetry=2'],
    ['lines of no region', 'auto=45,1,1024,1&lines=elbow:2'],
    ['a region of no face', 'auto=45,1,1024,1,elbow'],
    ['no end', `x=${'a'.repeat(30_000)}`],
  ])('with %s is refused in one line', (_, hash) => {
    expect(() => parseLink(hash, PAGE)).toThrow(/^Studio: the link cannot be used: [^\n]{1,1000}$/)
  })

  it('made of any text is read, or refused with one kind of error', () => {
    fc.assert(
      fc.property(
        fc.string({ maxLength: 200 }),
        fc.constantFrom('model', 'pose', 'camera', 'light', 'auto'),
        (text, name) => {
          try {
            parseLink(`#${name}=${text}`, PAGE)
          } catch (error) {
            expect((error as Error).name).toBe('FurrowError')
          }
        },
      ),
    )
  })

  it('with all regions names none of them', () => {
    const auto = { age: 20, strength: 0, size: 512, seed: 0 }
    expect(parseLink(formatLink({ auto }, PAGE), PAGE).auto).toEqual(auto)
    const all = { ...auto, regions: [...AUTO_REGIONS] }
    expect(parseLink(formatLink({ auto: all }, PAGE), PAGE).auto).toEqual(all)
  })
})
