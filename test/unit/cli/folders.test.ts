import { access } from 'node:fs/promises'
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import type { CommandName } from '../../commands.ts'
import { Workshop } from './workshop.ts'

// Mocks the check of permissions, because tests may run as root, who may write everywhere.
vi.mock('node:fs/promises', async (original) => {
  const module = await original<typeof import('node:fs/promises')>()
  return { ...module, access: vi.fn(module.access) }
})

const shop = new Workshop()

/** Arguments of every command that writes a folder. No input exists, so only an early check can find the folder's problem. */
const COMMANDS: [CommandName, (folder: string) => string[]][] = [
  ['array', (folder) => ['none.ktx2', '--extract', folder]],
  ['auto', (folder) => ['none.glb', '-o', shop.path('x.glb'), '--report', folder]],
  ['import', (folder) => ['none.json', '--face', 'none.glb', '-o', folder]],
  ['strokes', (folder) => ['none.json', '--face', 'none.glb', '--areas', folder]],
  ['unpack', (folder) => ['none.glb', '-o', folder]],
]

const isFolder = (path: unknown, name: string) => String(path) === shop.path(name)

beforeAll(() => shop.write('deep/file.txt', 'x'))

beforeEach(() => {
  vi.mocked(access).mockClear()
})

describe.each(COMMANDS)('before any work, the output folder', (command, args) => {
  const refuse = async (folder: string) => (await shop.failure(command, ...args(folder))).message

  it('must not be below a file', async () => {
    const folder = shop.path('deep/file.txt/new')
    expect(await refuse(folder)).toMatch(
      /: cannot write .*new \(.*file\.txt is not a folder\); choose another path$/,
    )
  })

  it('must not be a file', async () => {
    expect(await refuse(shop.path('deep/file.txt'))).toMatch(/file\.txt (is a file|\(it is not a folder\))/)
  })

  it.each(['-', '/dev/stdout'])('must not be stdout (%s)', async (path) => {
    expect(await refuse(path)).toMatch(
      /cannot write a folder to stdout \(stdout takes one file\); choose a folder$/,
    )
  })

  it('must be writable, or its parent must be', async () => {
    vi.mocked(access).mockImplementation(async (path) => {
      if (isFolder(path, 'deep')) throw Object.assign(new Error(), { code: 'EACCES' })
    })
    expect(await refuse(shop.path('deep/new/newer'))).toMatch(
      /cannot write .*newer \(permission denied\); ask its owner, or change its permissions$/,
    )
    vi.mocked(access).mockImplementation(async () => {})
    expect(await refuse(shop.path('deep/new/newer'))).toMatch(/cannot read .*none\.\w+ \(it does not exist\)/)
  })
})
