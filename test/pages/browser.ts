import { type Browser, chromium, type Page } from 'playwright-core'

/**
 * Lets a headless Chromium without a GPU run both WebGL 2 and WebGPU, and show what they drew. The last three
 * put the browser's own compositor on the same software Vulkan: a WebGPU canvas hands its pictures over through
 * Vulkan memory, and where the compositor cannot take them the GPU process dies ("A valid external Instance
 * reference no longer exists").
 */
export const CHROMIUM_FLAGS = [
  '--no-sandbox',
  '--ignore-gpu-blocklist',
  '--enable-unsafe-swiftshader',
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--disable-background-networking',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--use-angle=swiftshader',
]

/** The browser that pages are tested in; the caller closes it. */
export function openBrowser(): Promise<Browser> {
  return chromium.launch({
    executablePath: process.env.FURROW_CHROMIUM ?? '/usr/bin/chromium',
    args: CHROMIUM_FLAGS,
  })
}

/** An empty page, and what it will complain of: errors in its console, exceptions, requests that fail. */
export async function openPage(
  browser: Browser,
  options?: Parameters<Browser['newPage']>[0],
): Promise<{ page: Page; complaints: string[] }> {
  const page = await browser.newPage(options)
  const complaints: string[] = []
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text())
  })
  page.on('pageerror', (error) => complaints.push(error.stack ?? error.message))
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()} ${response.url()}`)
  })
  return { page, complaints }
}
