import { spawn } from 'node:child_process'
import { fileURLToPath } from 'node:url'

/** Path of the built command. */
export const BIN = fileURLToPath(new URL('../../packages/cli/bin/furrow.js', import.meta.url))

// Uses the built module, because the page that it opens is built too.
const RENDER_MODULE = '../../packages/cli/dist/render/render-pictures.js'

/** The function that `furrow render` calls. */
export const { renderPictures }: typeof import('../../packages/cli/src/render/render-pictures.ts') =
  await import(RENDER_MODULE)

export interface CommandResult {
  code: number | null
  stdout: string
  stderr: string
}

/** Starts the built command without a terminal. */
export function startFurrow(cwd: string, env: NodeJS.ProcessEnv, ...args: string[]) {
  return spawn(process.execPath, [BIN, ...args], {
    cwd,
    env: { ...process.env, ...env },
    stdio: ['ignore', 'pipe', 'pipe'],
  })
}

/** Runs the built command to its end without a terminal. */
export function runFurrow(cwd: string, env: NodeJS.ProcessEnv, ...args: string[]): Promise<CommandResult> {
  return new Promise((resolve, reject) => {
    const child = startFurrow(cwd, env, ...args)
    const [stdout, stderr]: [Buffer[], Buffer[]] = [[], []]
    child.stdout.on('data', (data) => stdout.push(data))
    child.stderr.on('data', (data) => stderr.push(data))
    child.on('error', reject)
    child.on('close', (code) =>
      resolve({ code, stdout: String(Buffer.concat(stdout)), stderr: String(Buffer.concat(stderr)) }),
    )
  })
}
