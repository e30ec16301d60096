import { basename, posix, resolve, sep } from 'node:path'
import { FurrowError } from 'furrow'
import { statOf } from 'furrow-files/node'
import { glob, isDynamicPattern } from 'tinyglobby'
import { listS3 } from '../stores/s3.ts'
import { isRemote } from '../stores/store-of.ts'

const WHO = 'furrow batch'

/** Input of a batch. `name` is the path of its output, relative to the output folder. */
export interface NamedInput {
  input: string
  name: string
  identity?: string
}

/** Finds the inputs of a batch from patterns, paths and URLs. Sorts them. Throws if a pattern has no match. */
export async function listInputs(
  patterns: readonly string[],
  reads: 'file' | 'folder',
): Promise<NamedInput[]> {
  const lists: NamedInput[][] = []
  for (const pattern of patterns) lists.push(await listOne(pattern, reads))
  // A file that matches several patterns is one input.
  const inputs = new Map(lists.flat().map((one) => [one.input, one]))
  return [...inputs.values()].sort((a, b) => (a.input < b.input ? -1 : 1))
}

async function listOne(pattern: string, reads: 'file' | 'folder'): Promise<NamedInput[]> {
  if (/^s3:/i.test(pattern) && pattern.endsWith('/')) {
    const found = await listS3(pattern)
    if (found.length === 0) throw noInput(pattern, 'no .glb or .vrm files below it')
    return found.map((one) => ({ input: one.address, name: one.address.slice(pattern.length), ...one }))
  }
  if (isRemote(pattern)) {
    if (reads === 'folder') throw noInput(pattern, 'furrow pack reads local folders')
    return [{ input: pattern, name: nameOf(pattern) }]
  }
  const found = await statOf(pattern).catch(() => undefined)
  if (found) {
    if (found.isDirectory() === (reads === 'folder')) return [{ input: pattern, name: nameOf(pattern) }]
    throw noInput(pattern, found.isDirectory() ? 'it is a folder' : 'it is a file')
  }
  const parts = pattern.split(sep).join('/').split('/')
  const first = parts.findIndex((part) => isDynamicPattern(part))
  if (first < 0) throw noInput(pattern, 'it does not exist')
  // Longest leading part of the pattern without wildcards. Names are relative to this folder.
  const base = parts.slice(0, first).join('/') || (pattern.startsWith('/') ? '/' : '.')
  const names = await glob(parts.slice(first).join('/'), {
    cwd: base,
    onlyDirectories: reads === 'folder',
    expandDirectories: false,
  })
  if (names.length === 0) throw noInput(pattern, 'no match')
  return names.map((found) => {
    const name = found.replace(/\/$/, '')
    return { input: posix.join(base, name), name }
  })
}

/** Returns the file name in a path or URL. Throws if a URL is invalid. */
export function nameOf(input: string): string {
  if (!isRemote(input)) return basename(resolve(input))
  if (!URL.canParse(input)) throw noInput(input, 'invalid URL')
  const { pathname } = new URL(input)
  try {
    return posix.basename(decodeURIComponent(pathname)) || 'face'
  } catch {
    return posix.basename(pathname)
  }
}

function noInput(pattern: string, problem: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: WHO,
    problem: `no input at ${pattern} (${problem})`,
    remedy: "give files, a quoted pattern such as 'avatars/**/*.glb', or a URL",
  })
}
