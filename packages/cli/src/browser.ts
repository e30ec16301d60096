import { accessSync, constants } from 'node:fs'
import { homedir } from 'node:os'
import { join } from 'node:path'
import { FurrowError } from 'furrow'
import { type Browser, chromium, type Page } from 'playwright-core'
import { CHROMIUM_FLAGS } from './chromium-flags.ts'

/** Milliseconds that a browser may take to start. */
const START = 300_000

/** Where browsers install themselves, the most common first. */
function usualPlaces(): string[] {
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
 * Path of a Chromium-based browser: the one that `FURROW_CHROMIUM` names, else an installed Chrome, Chromium or
 * Edge, else Playwright's own.
 *
 * @throws FurrowError when there is none, or `FURROW_CHROMIUM` names no program.
 */
export function findBrowser(): string {
  const named = process.env.FURROW_CHROMIUM
  if (named) {
    if (isProgram(named)) return named
    throw new FurrowError({
      who: 'furrow',
      what: 'FURROW_CHROMIUM is no program',
      value: named,
      limit: 'the path of Chrome, Chromium or Edge',
      remedy: 'correct the variable, or unset it to have the browser looked for',
    })
  }
  const found = [...usualPlaces(), chromium.executablePath()].find(isProgram)
  if (found) return found
  throw new FurrowError({
    who: 'furrow',
    what: 'no browser to draw with',
    limit: 'Chrome, Chromium or Edge',
    remedy: 'install one (e.g. "npx playwright install chromium"), or set FURROW_CHROMIUM to its path',
  })
}

/** Starts the browser that `findBrowser` finds, with no window. The caller closes it. */
export async function launchBrowser(): Promise<Browser> {
  const executablePath = findBrowser()
  try {
    return await chromium.launch({ executablePath, args: [...CHROMIUM_FLAGS], timeout: START })
  } catch (error) {
    throw new FurrowError({
      who: 'furrow',
      what: `the browser does not start (${String((error as Error).message).split('\n')[0]})`,
      value: executablePath,
      remedy: 'set FURROW_CHROMIUM to the path of another Chrome, Chromium or Edge',
    })
  }
}

/** An empty page. What is done in it may take as long as it must: a slow computer is no fault. */
export async function newPage(browser: Browser, options?: Parameters<Browser['newPage']>[0]): Promise<Page> {
  const page = await browser.newPage(options)
  page.setDefaultTimeout(0)
  return page
}

function isProgram(path: string): boolean {
  try {
    accessSync(path, constants.X_OK)
    return true
  } catch {
    return false
  }
}
