import { spawn } from 'node:child_process'
import { fileURLToPath } from 'node:url'

const BIN = fileURLToPath(new URL('../../packages/cli/bin/furrow.js', import.meta.url))

// As built, for its page is built too.
const DRAWING = '../../packages/cli/dist/render/render-pictures.js'

/** What `furrow render` draws with. */
export const { renderPictures }: typeof import('../../packages/cli/src/render/render-pictures.ts') =
  await import(DRAWING)

export interface Ended {
  code: number | null
  stdout: string
  stderr: string
}

/** Runs the built command, as users do, without a terminal. */
export function runFurrow(cwd: string, env: NodeJS.ProcessEnv, ...words: string[]): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [BIN, ...words], {
      cwd,
      env: { ...process.env, ...env },
      stdio: ['ignore', 'pipe', 'pipe'],
    })
    const [stdout, stderr]: [Buffer[], Buffer[]] = [[], []]
    child.stdout.on('data', (data) => stdout.push(data))
    child.stderr.on('data', (data) => stderr.push(data))
    child.on('error', reject)
    child.on('close', (code) =>
      resolve({ code, stdout: String(Buffer.concat(stdout)), stderr: String(Buffer.concat(stderr)) }),
    )
  })
}
