import { type ChildProcess, spawn } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { type BrowserKind, type DrivenBrowser, outputOf, type Start } from './driven-browser.ts'

/** Size and colour depth of the virtual display, larger than any tested window with its toolbars. */
const SCREEN = '1600x1300x24'

/**
 * Environment that selects Mesa's software rasteriser, and disables its fast path for 8-bit textures: that path rounds
 * filtered values to 8 bits, and the tests need more.
 */
const SOFTWARE = { LIBGL_ALWAYS_SOFTWARE: '1', GALLIVM_PERF: 'no_aos_sampling' }

/** Starts a browser on a virtual display. The caller must close the browser. */
export async function launch({ name, launch: start }: BrowserKind): Promise<DrivenBrowser> {
  const folder = mkdtempSync(join(tmpdir(), `furrow-${name}-`))
  const children: ChildProcess[] = []
  const end = () => {
    // A browser is several processes, so end their complete group.
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
