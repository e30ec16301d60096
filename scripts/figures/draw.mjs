/**
 * Draws pictures, and shows the progress.
 *
 * @param requests requests to `renderPictures`.
 * @returns the pictures in the order of the requests.
 */
export async function drawPictures(requests) {
  const { renderPictures } = await import('../../packages/cli/dist/render/render-pictures.js')
  // Pictures of one face follow each other, so that they share a page.
  const order = [...requests.keys()].sort((a, b) => compare(requests[a].input, requests[b].input) || a - b)
  const drawn = await withBar((progress) =>
    renderPictures(
      order.map((i) => requests[i]),
      progress,
    ),
  )
  const pictures = []
  for (const [k, i] of order.entries()) pictures[i] = drawn[k]
  return pictures
}

function compare(a, b) {
  return a < b ? -1 : Number(a > b)
}

async function withBar(work) {
  const { SingleBar } = await import('cli-progress')
  const bar = new SingleBar({
    format: 'figures {bar} {value}/{total}',
    stream: process.stderr,
    clearOnComplete: true,
  })
  let started = false
  try {
    return await work((done, total) => {
      if (!started) bar.start(total, 0)
      started = true
      bar.update(done)
    })
  } finally {
    bar.stop()
  }
}
