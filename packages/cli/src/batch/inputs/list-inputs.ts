import { basename, posix, resolve, sep } from 'node:path'
import { FurrowError } from 'furrow'
import { statOf } from 'furrow-files/node'
import { glob, isDynamicPattern } from 'tinyglobby'
import { isRemote } from '../places/places.ts'
import { listS3 } from '../places/s3.ts'

const WHO = 'furrow batch'

/** An input, and its name among those of its pattern: the name of its output below the folder of outputs. */
export interface NamedInput {
  input: string
  name: string
  identity?: string
}

/** Finds the inputs of patterns, paths and addresses, in one order. Throws FurrowError where one is nothing. */
export async function listInputs(
  patterns: readonly string[],
  reads: 'file' | 'folder',
): Promise<NamedInput[]> {
  const lists: NamedInput[][] = []
  for (const pattern of patterns) lists.push(await listOne(pattern, reads))
  // The same file by two patterns is one input.
  const inputs = new Map(lists.flat().map((one) => [one.input, one]))
  return [...inputs.values()].sort((a, b) => (a.input < b.input ? -1 : 1))
}

async function listOne(pattern: string, reads: 'file' | 'folder'): Promise<NamedInput[]> {
  if (/^s3:/i.test(pattern) && pattern.endsWith('/')) {
    const found = await listS3(pattern)
    if (found.length === 0) throw nothing(pattern, 'it has no .glb and no .vrm')
    return found.map((one) => ({ input: one.address, name: one.address.slice(pattern.length), ...one }))
  }
  if (isRemote(pattern)) {
    if (reads === 'folder') throw nothing(pattern, 'furrow pack reads folders of this machine')
    return [{ input: pattern, name: nameOf(pattern) }]
  }
  const found = await statOf(pattern).catch(() => undefined)
  if (found) {
    if (found.isDirectory() === (reads === 'folder')) return [{ input: pattern, name: nameOf(pattern) }]
    throw nothing(pattern, found.isDirectory() ? 'it is a folder' : 'it is a file')
  }
  const parts = pattern.split(sep).join('/').split('/')
  const first = parts.findIndex((part) => isDynamicPattern(part))
  if (first < 0) throw nothing(pattern, 'it does not exist')
  // The folder that all matches are in.
  const base = parts.slice(0, first).join('/') || (pattern.startsWith('/') ? '/' : '.')
  const names = await glob(parts.slice(first).join('/'), {
    cwd: base,
    onlyDirectories: reads === 'folder',
    expandDirectories: false,
  })
  if (names.length === 0) throw nothing(pattern, 'nothing matches it')
  return names.map((found) => {
    const name = found.replace(/\/$/, '')
    return { input: posix.join(base, name), name }
  })
}

/** The name of an input by itself: the last part of its path. Throws FurrowError where it is no address. */
export function nameOf(input: string): string {
  if (!isRemote(input)) return basename(resolve(input))
  if (!URL.canParse(input)) throw nothing(input, 'it is no address')
  const { pathname } = new URL(input)
  try {
    return posix.basename(decodeURIComponent(pathname)) || 'face'
  } catch {
    return posix.basename(pathname)
  }
}

function nothing(pattern: string, problem: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: WHO,
    problem: `no input at ${pattern} (${problem})`,
    remedy: "name files, a pattern in quotes such as 'avatars/**/*.glb', or an address",
  })
}
