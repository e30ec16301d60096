import { accessSync, constants } from 'node:fs'
import { homedir } from 'node:os'
import { join } from 'node:path'
import { FurrowError } from 'furrow'
import { firstLine } from 'furrow-files'
import type { Browser, Page } from 'playwright-core'
import { CHROMIUM_FLAGS } from './chromium-flags.ts'
import { temporaryFolder } from './interruption.ts'

/** Loads Playwright on demand. Few commands need it, and it takes as long to load as all other modules together. */
const playwright = async () => (await import('playwright-core')).chromium

/** Time limit for starting a browser, milliseconds. */
const START_TIMEOUT = 300_000

/** Returns the paths at which browsers are usually installed, most common browser first. */
function installPaths(): string[] {
  if (process.platform === 'darwin') {
    const apps = ['Google Chrome', 'Chromium', 'Microsoft Edge']
    return ['/Applications', join(homedir(), 'Applications')].flatMap((folder) =>
      apps.map((app) => join(folder, `${app}.app`, 'Contents', 'MacOS', app)),
    )
  }
  if (process.platform === 'win32') {
    const programs = ['Google/Chrome/Application/chrome.exe', 'Microsoft/Edge/Application/msedge.exe']
    const { PROGRAMFILES, LOCALAPPDATA } = process.env
    return [PROGRAMFILES, process.env['PROGRAMFILES(X86)'], LOCALAPPDATA]
      .filter((folder) => folder !== undefined)
      .flatMap((folder) => programs.map((program) => join(folder, program)))
  }
  const names = ['google-chrome', 'google-chrome-stable', 'chromium', 'chromium-browser', 'microsoft-edge']
  const folders = [...(process.env.PATH ?? '').split(':'), '/usr/bin', '/usr/local/bin', '/snap/bin']
  return names.flatMap((name) => folders.map((folder) => join(folder, name)))
}

/**
 * Finds a Chromium-based browser: the program in `FURROW_CHROMIUM`, otherwise an installed Chrome, Chromium or Edge,
 * otherwise the browser that Playwright installed.
 *
 * @returns path of the program.
 * @throws FurrowError if no browser is found, or `FURROW_CHROMIUM` is not a program.
 */
export async function findBrowser(): Promise<string> {
  const named = process.env.FURROW_CHROMIUM
  if (named) {
    if (isExecutable(named)) return named
    throw new FurrowError({
      code: 'unreadable',
      who: 'furrow',
      problem: 'FURROW_CHROMIUM is not a program',
      value: named,
      limit: 'the path of Chrome, Chromium or Edge',
      remedy: 'correct the variable, or unset it to use an installed browser',
    })
  }
  const installed = installPaths().find(isExecutable)
  if (installed !== undefined) return installed
  const own = (await playwright()).executablePath()
  if (isExecutable(own)) return own
  throw new FurrowError({
    code: 'unsupported',
    who: 'furrow',
    problem: 'no browser found',
    limit: 'Chrome, Chromium or Edge',
    remedy: 'install one (e.g. "npx playwright install chromium"), or set FURROW_CHROMIUM to its path',
  })
}

/**
 * Starts the browser from `findBrowser` in headless mode. The caller closes the browser. If a signal ends this process,
 * the browser ends too and its temporary files are removed.
 *
 * @param flags flags in addition to `CHROMIUM_FLAGS`.
 */
export async function launchBrowser(flags: readonly string[] = []): Promise<Browser> {
  const executablePath = await findBrowser()
  const folder = temporaryFolder()
  try {
    const chromium = await playwright()
    const browser = await inFolder(folder.path, () =>
      chromium.launch({
        executablePath,
        args: [...CHROMIUM_FLAGS, ...flags],
        timeout: START_TIMEOUT,
        handleSIGHUP: false,
        handleSIGINT: false,
        handleSIGTERM: false,
      }),
    )
    browser.on('disconnected', () => void folder.remove())
    return browser
  } catch (error) {
    await folder.remove()
    throw new FurrowError(
      {
        code: 'unsupported',
        who: 'furrow',
        problem: `cannot start the browser (${firstLine(error)})`,
        value: executablePath,
        remedy: 'set FURROW_CHROMIUM to the path of another Chrome, Chromium or Edge',
      },
      { cause: error },
    )
  }
}

/** Runs `work` with TMPDIR set to a folder. Playwright and the browser write their temporary files there. */
async function inFolder<T>(folder: string, work: () => Promise<T>): Promise<T> {
  const { TMPDIR } = process.env
  process.env.TMPDIR = folder
  try {
    return await work()
  } finally {
    if (TMPDIR === undefined) delete process.env.TMPDIR
    else process.env.TMPDIR = TMPDIR
  }
}

/** Opens an empty page without time limits, because a software rasteriser can be slow. */
export async function newPage(browser: Browser, options?: Parameters<Browser['newPage']>[0]): Promise<Page> {
  const page = await browser.newPage(options)
  page.setDefaultTimeout(0)
  return page
}

function isExecutable(path: string): boolean {
  try {
    accessSync(path, constants.X_OK)
    return true
  } catch {
    return false
  }
}
