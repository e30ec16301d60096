// Runs in a browser, without drawing, because Node has no IndexedDB, locks and storage quota.

import { signal } from '@preact/signals'
import { openDB } from 'idb'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { paintArea, removeArea, setArea } from '../../../studio/src/document/areas.ts'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { AutoSave } from '../../../studio/src/keep/autosave.ts'
import type { Project } from '../../../studio/src/keep/project.ts'
import { ProjectStore } from '../../../studio/src/keep/project-store.ts'
import { sampleDocument, weightsOf } from '../../unit/studio/sample-document.ts'

const document = sampleDocument()
/** Weights of three areas, a normal map, a tile of sculpted heights, and weights of two takes. */
const IMAGES = 7
const TILE_BYTES = 2 * 64 ** 2
const TAKE_BYTES = 7 * 4
const face = { path: 'avatar/face.glb', file: new Blob(['glTF and so on']) }
const FILES = [face, { path: 'avatar/skin.png', file: new Blob(['a picture']) }]

let name: string
let stores: ProjectStore[]
let projects: Project[]

/** Opens a store as another tab would, or as this page after a reload. */
function openStore(): ProjectStore {
  const store = new ProjectStore(name)
  stores.push(store)
  return store
}

async function create(store: ProjectStore, of = document): Promise<Project> {
  const project = await store.create('Face', FILES, of)
  projects.push(project)
  return project
}

/** Closes all stores without saving, like a crash, and opens the project again. */
async function reopen(id: string): Promise<Project> {
  for (const project of projects) await project.close()
  for (const store of stores) store.close()
  const project = await openStore().open(id)
  projects.push(project)
  return project
}

/** Returns all records of a database table by key. */
async function recordsOf(table: string): Promise<Map<string, unknown>> {
  const database = await openDB(name)
  const [keys, values] = await Promise.all([database.getAllKeys(table), database.getAll(table)])
  database.close()
  return new Map(keys.map((key, i) => [JSON.stringify(key), values[i]]))
}

async function changeRecord(table: string, key: IDBValidKey, value: unknown): Promise<void> {
  const database = await openDB(name)
  if (value === undefined) await database.delete(table, key)
  else await database.put(table, value, key)
  database.close()
}

/** Counts the writes to a database table. */
function watchWrites(table: string) {
  const put = IDBObjectStore.prototype.put
  const written: unknown[] = []
  vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function (this: IDBObjectStore, value, key) {
    if (this.name === table) written.push(value)
    return put.call(this, value, key)
  })
  return written
}

/** Makes every write to a database table fail. */
function failPuts(table: string, error: string): void {
  const put = IDBObjectStore.prototype.put
  vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function (this: IDBObjectStore, value, key) {
    if (this.name === table) throw new DOMException('', error)
    return put.call(this, value, key)
  })
}

beforeEach(() => {
  name = `test ${crypto.randomUUID()}`
  stores = []
  projects = []
})

afterEach(async () => {
  vi.restoreAllMocks()
  vi.unstubAllGlobals()
  for (const project of projects) await project.close()
  for (const store of stores) store.close()
  indexedDB.deleteDatabase(name)
})

describe('a project', () => {
  it('reopens after the page was closed, with its files as dropped', async () => {
    const { id } = await create(openStore())
    const project = await reopen(id)
    expect(project.opened).toEqual(document)
    expect(project.files.map(({ path }) => path)).toEqual(['avatar/face.glb', 'avatar/skin.png'])
    expect(await project.files[0].file.text()).toBe('glTF and so on')
    expect(project.isReadOnly).toBe(false)
  })

  it('is listed with name, date, size and picture, newest first', async () => {
    const store = openStore()
    const first = await create(store)
    await create(store)
    await first.save(setArea(document, 'frown', { activation: 1 }))
    await first.setThumbnail(new Blob(['small'], { type: 'image/png' }))
    const [entry, other] = await store.list()
    expect(entry).toMatchObject({
      id: first.id,
      name: 'Face',
      bytes: 3 * 16 + 3 + 14 + 9 + TILE_BYTES + TAKE_BYTES,
    })
    expect(entry.problem).toBeUndefined()
    expect(entry.changed!.getTime()).toBeGreaterThanOrEqual(other.changed!.getTime())
    expect(await entry.thumbnail!.text()).toBe('small')
    expect(other.thumbnail).toBeUndefined()
  })

  it('can be renamed while open, duplicated and deleted', async () => {
    const store = openStore()
    const project = await create(store)
    await project.setThumbnail(new Blob(['small']))
    await store.rename(project.id, 'Head')
    await project.save(removeArea(document, 'frown'))
    const copy = await store.duplicate(project.id, 'Head 2')
    expect((await store.list()).map((entry) => entry.name).sort()).toEqual(['Head', 'Head 2'])
    await expect(store.delete(project.id)).rejects.toThrow('is open in another tab; close it there first')
    await project.close()
    await store.delete(project.id)
    const [entry, ...others] = await store.list()
    expect(others).toEqual([])
    expect(await entry.thumbnail!.text()).toBe('small')
    expect((await reopen(copy)).opened).toEqual(removeArea(document, 'frown'))
    for (const table of ['images', 'files', 'documents', 'saves', 'thumbnails']) {
      expect([...(await recordsOf(table)).keys()].every((key) => key.includes(copy))).toBe(true)
    }
  })

  it('that was deleted cannot be opened', async () => {
    await expect(openStore().open('nothing')).rejects.toThrow('Studio: the project is gone')
    await expect(openStore().rename('nothing', 'x')).rejects.toThrow('Studio: the project is gone')
  })
})

describe('a save', () => {
  it('writes only new images', async () => {
    const project = await create(openStore())
    const written = watchWrites('images')
    await project.save(setArea(document, 'frown', { activation: 1 }))
    expect(written).toEqual([])
    const painted = paintArea(document, 'frown', weightsOf(7))
    await project.save(painted)
    expect(written).toEqual([painted.areas[1].weights])
    await project.save(painted)
    expect(written.length).toBe(1)
    expect((await reopen(project.id)).opened).toEqual(painted)
  })

  it('writes only new images of a reopened project', async () => {
    const project = await reopen((await create(openStore())).id)
    const written = watchWrites('images')
    const painted = paintArea(project.opened, 'frown', weightsOf(7))
    await project.save(painted)
    expect(written).toEqual([painted.areas[1].weights])
    expect((await reopen(project.id)).opened).toEqual(painted)
  })

  it('deletes images that the document no longer uses, and stores them again after undo', async () => {
    const project = await create(openStore())
    await project.save(removeArea(document, 'frown'))
    expect((await recordsOf('images')).size).toBe(IMAGES - 1)
    await project.save(document)
    expect((await recordsOf('images')).size).toBe(IMAGES)
    expect((await reopen(project.id)).opened).toEqual(document)
  })

  it('stores an image shared by two areas once, without the rest of its buffer', async () => {
    const whole = new Uint8Array(1 << 20)
    const bytes = whole.subarray(100, 103)
    const { weights } = document.areas[0]
    const layers = [{ ...document.layers[0], maps: { normal: { mimeType: 'image/png', bytes } } }]
    const areas = document.areas.map((area) => ({ ...area, weights }))
    await create(openStore(), { ...document, layers, areas })
    const images = [...(await recordsOf('images')).values()] as { bytes?: Uint8Array }[]
    // Weights of areas, a normal map, and weights of two takes.
    expect(images.length).toBe(4)
    expect(images.find((image) => image.bytes)!.bytes!.buffer.byteLength).toBe(3)
  })

  it('is atomic', async () => {
    const project = await create(openStore())
    const before = await recordsOf('images')
    failPuts('saves', 'UnknownError')
    const painted = paintArea(document, 'frown', weightsOf(7))
    await expect(project.save(painted)).rejects.toThrow("the browser's storage failed")
    vi.restoreAllMocks()
    expect(await recordsOf('images')).toEqual(before)
    expect((await reopen(project.id)).opened).toEqual(document)
  })

  it('continues after the browser closed or cleared its storage', async () => {
    const store = openStore()
    const project = await create(store)
    store.close()
    const painted = paintArea(document, 'frown', weightsOf(7))
    await project.save(painted)
    expect((await recordsOf('images')).size).toBe(IMAGES)
    store.close()
    await new Promise((resolve) => {
      indexedDB.deleteDatabase(name).onsuccess = resolve
    })
    await project.save(painted)
    const again = await reopen(project.id)
    expect(again.opened).toEqual(painted)
    expect(await again.files[1].file.text()).toBe('a picture')
  })

  it('is committed during the event pagehide', async () => {
    const project = await create(openStore())
    const edited = signal<StudioDocument>(document)
    const autosave = new AutoSave(edited, (next) => project.save(next))
    const commits = vi.spyOn(IDBTransaction.prototype, 'commit')
    edited.value = paintArea(document, 'frown', weightsOf(7))
    dispatchEvent(new Event('pagehide'))
    expect(commits).toHaveBeenCalledTimes(1)
    await autosave.dispose()
    expect(autosave.state.value.kind).toBe('saved')
    expect((await reopen(project.id)).opened).toEqual(edited.value)
  })
})

describe('failing storage', () => {
  it('keeps the saved project when full, and saves again once there is room', async () => {
    const project = await create(openStore())
    const painted = paintArea(document, 'frown', weightsOf(7))
    failPuts('documents', 'QuotaExceededError')
    await expect(project.save(painted)).rejects.toThrow('Studio: the browser has no room left')
    vi.restoreAllMocks()
    expect((await recordsOf('images')).size).toBe(IMAGES)
    await project.save(painted)
    expect((await reopen(project.id)).opened).toEqual(painted)
  })

  it('reports one clear message if the browser blocks storage', async () => {
    vi.stubGlobal('indexedDB', undefined)
    await expect(openStore().list()).rejects.toThrow(
      'Studio: the browser does not let this page store anything',
    )
    vi.unstubAllGlobals()
    vi.spyOn(IDBFactory.prototype, 'open').mockImplementation(() => {
      throw new DOMException('A mutation operation was attempted', 'InvalidStateError')
    })
    await expect(create(openStore())).rejects.toThrow('does not let this page store anything')
  })

  it('reports one clear message if a later version of the page stored there', async () => {
    ;(await openDB(name, 99)).close()
    await expect(openStore().list()).rejects.toThrow(
      'stored by a later version of the studio; reload the page',
    )
  })
})

describe('invalid records', () => {
  it('do not prevent the listing of others', async () => {
    const store = openStore()
    const [whole, damaged] = [await create(store), await create(store)]
    await changeRecord('projects', damaged.id, { version: 1 })
    await changeRecord('projects', 'another', null)
    const entries = await store.list()
    expect(entries.length).toBe(3)
    expect(entries.find(({ id }) => id === whole.id)).toMatchObject({ name: 'Face' })
    expect(entries.filter(({ problem }) => problem === 'its record is damaged').length).toBe(2)
  })

  it('of a later version are listed, and refused with a clear message', async () => {
    const store = openStore()
    const project = await create(store)
    await changeRecord('projects', project.id, { version: 2, name: 'Face' })
    expect((await store.list())[0].problem).toMatch('Face was stored by a later version of the studio, got 2')
    await expect(reopen(project.id)).rejects.toThrow('stored by a later version')
  })

  it.each([
    ['a document', 'documents', undefined, 'it has no document'],
    ['an image', 'images', undefined, /its (area|map) \w+ is missing/],
    ['the parts of a document', 'documents', { version: 1, document: {} }, 'layers must be an array'],
    ['the right version of a document', 'documents', { version: 3 }, 'stored by a later version'],
  ])('without %s are refused with a clear message', async (_, table, value, message) => {
    const project = await create(openStore())
    const [key] = (await recordsOf(table)).keys()
    await changeRecord(table, JSON.parse(key), value)
    await expect(reopen(project.id)).rejects.toThrow(message)
  })
})

describe('two tabs with one project', () => {
  it('let the second tab open the project, but not save it', async () => {
    const first = await create(openStore())
    const second = await openStore().open(first.id)
    expect([first.isReadOnly, second.isReadOnly]).toEqual([false, true])
    await expect(second.save(removeArea(document, 'frown'))).rejects.toThrow(
      'Studio: Face is open in another tab; save a copy, or close this tab',
    )
    const painted = paintArea(document, 'frown', weightsOf(7))
    await first.save(painted)
    expect((await reopen(first.id)).opened).toEqual(painted)
  })

  it('let the second tab save a copy', async () => {
    const first = await create(openStore())
    const store = openStore()
    const second = await store.open(first.id)
    const copy = await store.create('Face 2', second.files, removeArea(second.opened, 'frown'))
    expect(copy.isReadOnly).toBe(false)
    await copy.close()
    expect((await reopen(copy.id)).opened).toEqual(removeArea(document, 'frown'))
  })

  it('let the second tab take over once the first has saved', async () => {
    const first = await create(openStore())
    const changed = removeArea(document, 'frown')
    first.onRequested(() => void first.save(changed).then(() => first.close()))
    const second = await openStore().open(first.id, true)
    expect([first.isReadOnly, second.isReadOnly]).toEqual([true, false])
    expect(second.opened).toEqual(changed)
    await expect(first.save(document)).rejects.toThrow('Studio: Face is open in another tab')
    await second.close()
  })

  it('let the second tab take over if the first does not answer', async () => {
    const first = await create(openStore())
    let isWanted = 0
    first.onRequested(() => isWanted++)
    const second = await openStore().open(first.id, true)
    expect([first.isReadOnly, second.isReadOnly]).toEqual([true, false])
    // The first tab is notified twice: when the second tab asks for the project, and after it has taken the project.
    await expect.poll(() => isWanted).toBe(2)
    await second.close()
  })

  it.each([false, true])(
    'let the second tab save once the first has closed it, unless it saved: %s',
    async (isSaved) => {
      const first = await create(openStore())
      const second = await openStore().open(first.id)
      const waiting = second.reclaim(new AbortController().signal)
      if (isSaved) await first.save(removeArea(document, 'frown'))
      await first.close()
      expect(await waiting).toBe(isSaved)
      expect(second.isReadOnly).toBe(isSaved)
      await second.close()
    },
  )

  it('let the next tab that opens it save after the first has closed it', async () => {
    const first = await create(openStore())
    await first.close()
    const second = await openStore().open(first.id)
    expect(second.isReadOnly).toBe(false)
    await second.close()
  })
})
