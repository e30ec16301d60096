/** Drops files and folders on a page, as if a user dragged them there. Uses the DevTools protocol. */
export async function dropPaths(page, files) {
  const session = await page.context().newCDPSession(page)
  const data = { items: [], files, dragOperationsMask: 1 }
  for (const type of ['dragEnter', 'dragOver', 'drop']) {
    await session.send('Input.dispatchDragEvent', { type, x: 100, y: 100, data })
  }
  await session.detach()
}
