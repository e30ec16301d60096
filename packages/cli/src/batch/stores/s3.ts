import type { Readable } from 'node:stream'
import type { S3Client } from '@aws-sdk/client-s3'
import { FurrowError } from 'furrow'
import { cannotRead, cannotWrite, firstLine } from 'furrow-files'
import { optionalPackage } from '../optional-package.ts'
import { bytesOf, download } from './download.ts'
import type { FileStore, ListedObject } from './file-store.ts'
import { changedInput } from './local-files.ts'

const WHO = 'furrow batch'

/**
 * Store of S3 and compatible servers. The AWS SDK reads credentials, region and endpoint from the environment
 * (https://docs.aws.amazon.com/sdkref/latest/guide/environment-variables.html).
 */
export const s3: FileStore = {
  async identify(address) {
    const { HeadObjectCommand } = await sdk()
    return withErrors(cannotRead, address, async (client) => {
      return identityOf((await client.send(new HeadObjectCommand(objectOf(address)))).ETag)
    })
  },
  async fetch(address, identity, _, scratch) {
    const { GetObjectCommand } = await sdk()
    return withErrors(cannotRead, address, async (client) => {
      const { Body, ETag } = await client.send(new GetObjectCommand(objectOf(address)))
      if (identityOf(ETag) !== identity) throw changedInput(address)
      return (await download(Body as Readable, address, scratch)).path
    })
  },
  async read(address) {
    const { GetObjectCommand } = await sdk()
    return withErrors(cannotRead, address, async (client) => {
      const { Body } = await client.send(new GetObjectCommand(objectOf(address)))
      return bytesOf(Body as Readable, address)
    })
  },
  async put(address, bytes) {
    const { PutObjectCommand } = await sdk()
    // One request is atomic: an incomplete upload does not change the object.
    const object = { ...objectOf(address), Body: bytes, ContentType: 'model/gltf-binary' }
    await withErrors(cannotWrite, address, (client) => client.send(new PutObjectCommand(object)))
  },
  async sizeOf(address) {
    const { HeadObjectCommand } = await sdk()
    return withErrors(cannotRead, address, async (client) => {
      try {
        return (await client.send(new HeadObjectCommand(objectOf(address)))).ContentLength
      } catch (error) {
        if (statusOf(error) === 404) return undefined
        throw error
      }
    })
  },
}

export async function listS3(address: string): Promise<ListedObject[]> {
  const { paginateListObjectsV2 } = await sdk()
  const { Bucket, Key: Prefix } = objectOf(address)
  return withErrors(cannotRead, address, async (client) => {
    const found: ListedObject[] = []
    for await (const page of paginateListObjectsV2({ client }, { Bucket, Prefix })) {
      for (const { Key = '', ETag } of page.Contents ?? []) {
        if (/\.(glb|vrm)$/i.test(Key))
          found.push({ address: `s3://${Bucket}/${Key}`, identity: identityOf(ETag) })
      }
    }
    return found
  })
}

/** Parses `s3://bucket/key`. The key is not percent-encoded. */
function objectOf(address: string): { Bucket: string; Key: string } {
  const [, Bucket, Key] = /^s3:\/\/([^/]+)\/(.*)$/.exec(address) ?? []
  if (Bucket) return { Bucket, Key }
  throw new FurrowError({
    code: 'usage',
    who: WHO,
    problem: 'invalid S3 URL',
    value: address,
    limit: 's3://bucket/key',
    remedy: 'correct the URL',
  })
}

/**
 * Returns a content identity from an ETag. An ETag is a hash of the content. With some encryptions, it is a random
 * number that changes with each upload.
 */
const identityOf = (tag: string | undefined) => `s3:${tag}`

const sdk = () => optionalPackage(() => import('@aws-sdk/client-s3'), '@aws-sdk/client-s3', 'an s3:// URL')

let client: Promise<S3Client> | undefined

/** Creates the S3 client. Sets `forcePathStyle` unless the server is Amazon's: others have no host name per bucket. */
function connect(): Promise<S3Client> {
  client ??= sdk().then(({ S3Client }) => {
    const { AWS_ENDPOINT_URL, AWS_ENDPOINT_URL_S3, AWS_REGION } = process.env
    const isOwn = Boolean(AWS_ENDPOINT_URL_S3 ?? AWS_ENDPOINT_URL)
    return new S3Client(isOwn ? { forcePathStyle: true, region: AWS_REGION ?? 'us-east-1' } : {})
  })
  return client
}

const statusOf = (error: unknown) =>
  (error as { $metadata?: { httpStatusCode?: number } }).$metadata?.httpStatusCode

async function withErrors<T>(
  report: typeof cannotRead | typeof cannotWrite,
  address: string,
  work: (client: S3Client) => Promise<T>,
): Promise<T> {
  try {
    return await work(await connect())
  } catch (error) {
    if (error instanceof FurrowError) throw error
    const status = statusOf(error)
    const known = { 403: 'access denied', 404: 'it does not exist' }[status ?? 0]
    const message = known ?? (firstLine(error) || `HTTP status ${status}`)
    throw report(WHO, address, Object.assign(new Error(message, { cause: error }), status && { status }))
  }
}
