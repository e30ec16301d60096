import { type ChildProcess, spawn } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { type BrowserKind, type DrivenBrowser, outputOf, type Start } from './driven-browser.ts'

/** Larger than any test window plus the browser's toolbars. */
const SCREEN = '1600x1300x24'

/** Mesa's software rasteriser. Its fast path for 8-bit textures filters with 8 bits, less than tests allow, so it is disabled. */
const SOFTWARE = { LIBGL_ALWAYS_SOFTWARE: '1', GALLIVM_PERF: 'no_aos_sampling' }

/** Starts a browser on its own display. The caller must close it. */
export async function launch({ name, launch: start }: BrowserKind): Promise<DrivenBrowser> {
  const folder = mkdtempSync(join(tmpdir(), `furrow-${name}-`))
  const children: ChildProcess[] = []
  const end = () => {
    // Ends process groups, because a browser is several processes.
    for (const { pid } of children.toReversed()) if (pid) endGroup(pid)
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 })
  }
  process.once('exit', end)
  let display = ''
  const run: Start['run'] = (program, words, env = {}) => {
    const child = spawn(program, words, {
      detached: true,
      stdio: ['ignore', 'pipe', 'pipe'],
      env: { ...process.env, ...SOFTWARE, DISPLAY: display, HOME: folder, ...env },
    })
    child.stderr.resume()
    child.stdout.resume()
    children.push(child)
    return child
  }
  try {
    const screen = run('Xvfb', ['-displayfd', '1', '-screen', '0', SCREEN, '-nolisten', 'tcp'])
    display = `:${await outputOf(screen, 'stdout', /(\d+)\n/)}`
    const browser = await start({ folder, run })
    const close = async () => {
      await browser.close().catch(() => {})
      process.off('exit', end)
      end()
    }
    return { ...browser, close }
  } catch (error) {
    process.off('exit', end)
    end()
    throw error
  }
}

function endGroup(pid: number): void {
  try {
    process.kill(-pid, 'SIGKILL')
  } catch {
    // The process has already exited.
  }
}
