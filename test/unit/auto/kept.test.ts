import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { keep, keyOf, pack, recall } from '../../../packages/furrow/src/auto/kept.ts'

const DATA = {
  name: 'ä',
  bytes: Uint8Array.of(1, 2, 3),
  nested: [{ floats: Float32Array.of(0.5, -1) }, { doubles: new Float64Array(3), curve: [[0.1, 1]] }],
}

/** Fake of Cache Storage with the methods that Furrow uses. */
class FakeCache {
  readonly entries = new Map<string, ArrayBuffer>()
  async match(url: string) {
    const body = this.entries.get(url)
    return body && new Response(body)
  }
  async put(url: string, response: Response) {
    this.entries.set(url, await response.arrayBuffer())
  }
  async keys() {
    return [...this.entries.keys()]
  }
  async delete(url: string) {
    return this.entries.delete(url)
  }
}

let stored: Map<string, FakeCache>
beforeEach(() => {
  stored = new Map()
  vi.stubGlobal('caches', {
    async open(name: string) {
      if (!stored.has(name)) stored.set(name, new FakeCache())
      return stored.get(name)
    },
    keys: async () => [...stored.keys()],
    delete: async (name: string) => stored.delete(name),
  })
})
afterEach(() => {
  vi.unstubAllGlobals()
})

describe('a cached result', () => {
  it('is found only under its key', async () => {
    await keep('v1', 'a', [pack(DATA)])
    expect(await recall('v1', 'a')).toEqual([DATA])
    expect(await recall('v1', 'b')).toBeUndefined()
    expect(await recall('v2', 'a')).toBeUndefined()
  })

  it('has several parts in their order', async () => {
    const parts = [['a note'], DATA, { empty: new Float32Array(0) }, DATA]
    await keep('v1', 'a', parts.map(pack))
    expect(await recall('v1', 'a')).toEqual(parts)
  })

  it('is a copy, so the caller may transfer the original', async () => {
    const data = structuredClone(DATA)
    const packed = pack(data)
    structuredClone(data.bytes, { transfer: [data.bytes.buffer] })
    expect(data.bytes.length).toBe(0)
    await keep('v1', 'a', [packed])
    expect(await recall('v1', 'a')).toEqual([DATA])
  })

  it('is dropped by another version, and when 32 newer ones are stored', async () => {
    stored.set('of-the-page', new FakeCache())
    await keep('v1', 'a', [pack(DATA)])
    for (let i = 0; i < 40; i++) await keep('v2', String(i), [pack(DATA)])
    expect([...stored.keys()].sort()).toEqual(['furrow-auto-v2', 'of-the-page'])
    expect(stored.get('furrow-auto-v2')!.entries.size).toBe(32)
    expect(await recall('v2', '39')).toEqual([DATA])
    expect(await recall('v2', '0')).toBeUndefined()
  })

  it('is ignored if damaged', async () => {
    await keep('v1', 'a', [pack(DATA)])
    const { entries } = stored.get('furrow-auto-v1')!
    for (const [url, body] of entries) entries.set(url, body.slice(0, body.byteLength / 2))
    expect(await recall('v1', 'a')).toBeUndefined()
  })

  it.each([
    ['there is no storage', undefined],
    ['storage is blocked', { open: refuse, keys: refuse }],
    [
      'the disk is full',
      { keys: async () => [], open: async () => ({ keys: async () => [], put: refuse, match: refuse }) },
    ],
  ])('is skipped without an error if %s', async (_, storage) => {
    vi.stubGlobal('caches', storage)
    await keep('v1', 'a', [pack(DATA)])
    expect(await recall('v1', 'a')).toBeUndefined()
  })
})

describe('a cache key', () => {
  it('depends on the content', async () => {
    const key = await keyOf(DATA)
    expect(key).toMatch(/^[0-9a-f]{64}$/)
    expect(await keyOf(structuredClone(DATA))).toBe(key)
    expect(await keyOf({ ...DATA, bytes: Uint8Array.of(1, 2, 4) })).not.toBe(key)
    expect(await keyOf({ ...DATA, name: 'b' })).not.toBe(key)
  })

  it('is undefined on pages over plain HTTP, where nothing is cached', async () => {
    vi.stubGlobal('crypto', {})
    expect(await keyOf(DATA)).toBeUndefined()
    await keep('v1', undefined, [pack(DATA)])
    expect(await recall('v1', undefined)).toBeUndefined()
    expect(stored.size).toBe(0)
  })
})

async function refuse(): Promise<never> {
  throw new DOMException('refused', 'QuotaExceededError')
}
