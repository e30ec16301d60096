import { FurrowError } from 'furrow'
import type { Browser, Page } from 'playwright-core'
import { launchBrowser, newPage } from '../browser.ts'
import { firstLine } from '../images.ts'
import { type LocalServer, startLocalServer } from './local-server.ts'
import type { PageJob, PageReport, PictureRequest } from './picture.ts'
import { type PreparedPicture, preparePicture } from './prepare.ts'

export interface Picture extends PageReport {
  width: number
  height: number
  /** RGBA, sRGB, row 0 at the top. */
  pixels: Uint8Array
  /** Until the last pixel; for the first picture of a face from opening its page. */
  milliseconds: number
}

/** Called before each picture and once after the last; `done` counts pictures. */
export type Progress = (done: number, total: number) => void

/**
 * Draws pictures in one browser without a window, one after the other; those of one face that follow each other are
 * drawn in one page, which takes a fraction of the time. Every request is checked before the browser starts. Nothing is
 * written.
 *
 * @throws FurrowError when a request is bad, no browser is found, or a picture cannot be drawn.
 */
export async function renderPictures(
  requests: readonly PictureRequest[],
  progress: Progress = () => {},
): Promise<Picture[]> {
  const prepared: PreparedPicture[] = []
  for (const request of requests) prepared.push(await preparePicture(request))
  const browser = await launchBrowser()
  try {
    const server = await startLocalServer()
    try {
      return await drawAll(browser, server, prepared, progress)
    } finally {
      await server.close()
    }
  } finally {
    await browser.close()
  }
}

async function drawAll(
  browser: Browser,
  server: LocalServer,
  prepared: PreparedPicture[],
  progress: Progress,
): Promise<Picture[]> {
  const pictures: Picture[] = []
  let page: Page | undefined
  for (const [i, picture] of prepared.entries()) {
    progress(i, prepared.length)
    // A page for each face: a lost device or a leak then cannot spoil the next.
    if (i === 0 || !isOfOneScene(picture, prepared[i - 1])) {
      await page?.close()
      page = await newPage(browser)
    }
    pictures.push(await drawOne(page!, server, picture))
  }
  progress(prepared.length, prepared.length)
  return pictures
}

/** Whether a page that has drawn one can draw the other too. */
function isOfOneScene({ job: a }: PreparedPicture, { job: b }: PreparedPicture): boolean {
  return a.face === b.face && a.wrinkles === b.wrinkles && a.mesh === b.mesh && a.renderer === b.renderer
}

async function drawOne(page: Page, server: LocalServer, { job, files }: PreparedPicture): Promise<Picture> {
  const start = performance.now()
  for (const file of files) server.offer(file)
  const inbox = server.inbox()
  const pageJob: PageJob = {
    ...job,
    face: server.offer(job.face),
    wrinkles: job.wrinkles && server.offer(job.wrinkles),
    deliver: inbox.address,
  }
  const plain = (text: string) => text.replaceAll(`${server.origin}/file`, '')
  const report = await askPage(page, server, pageJob).catch((error) => ({
    // Playwright begins with the name of its own method, which says nothing to a user.
    error: firstLine(error).replace(/^page\.\w+: /, ''),
  }))
  if ('error' in report) throw drawingFailed(job.face, plain(firstLine(report.error)))
  const pixels = inbox.received()
  if (!pixels) throw drawingFailed(job.face, 'the page delivered no pixels')
  return {
    ...report,
    warnings: report.warnings.map(plain),
    width: job.width,
    height: job.height,
    pixels,
    milliseconds: Math.round(performance.now() - start),
  }
}

async function askPage(
  page: Page,
  server: LocalServer,
  job: PageJob,
): Promise<PageReport | { error: string }> {
  const crashed = new Promise<{ error: string }>((resolve) => {
    page.once('crash', () => resolve({ error: 'the browser ran out of memory or crashed' }))
  })
  if (page.url() !== server.page) await open(page, server)
  return Promise.race([crashed, page.evaluate((asked) => window.drawPicture(asked), job)])
}

async function open(page: Page, server: LocalServer): Promise<void> {
  await page.route(
    (url) => !url.href.startsWith(server.origin) && !['data:', 'blob:'].includes(url.protocol),
    (route) => route.abort(),
  )
  await page.goto(server.page)
}

function drawingFailed(face: string, problem: string): FurrowError {
  return new FurrowError({
    who: 'furrow render',
    what: `${face} cannot be drawn (${problem})`,
    remedy: 'correct the input, or try the other --renderer',
  })
}
