// The jobs of the folder, followed while a screen displays them.

import { eventsOf, isOpen, listJobs, type Job } from "../api/jobs";

/** Interval between updates of the whole list, ms, because other tabs also start jobs. */
const LOOK_MS = 4000;

export class JobList {
  jobs = $state.raw<Job[] | null>(null);
  problem = $state.raw<unknown>(null);
  #events: { id: string; source: EventSource } | null = null;
  #ended: (job: Job) => void;

  /** `ended` is called with each job that ends while it is followed. */
  constructor(ended: (job: Job) => void = () => {}) {
    this.#ended = ended;
  }

  /** Follows the jobs until the returned function is called; return it from an effect. */
  follow(): () => void {
    void this.look();
    const timer = setInterval(() => void this.look(), LOOK_MS);
    return () => {
      clearInterval(timer);
      this.#close();
    };
  }

  /** Updates the whole list. */
  async look(): Promise<void> {
    try {
      const before = new Map((this.jobs ?? []).map((job) => [job.id, job]));
      this.jobs = await listJobs();
      this.problem = null;
      for (const job of this.jobs) {
        const known = before.get(job.id);
        if (known && isOpen(known) && !isOpen(job)) this.#ended(job);
      }
    } catch (problem) {
      this.problem = problem;
    }
    this.#listen();
  }

  #close(): void {
    this.#events?.source.close();
    this.#events = null;
  }

  /** Follows the events of the running job, of which there is one at a time. */
  #listen(): void {
    const running = this.jobs?.find((job) => job.state === "running");
    if (this.#events && this.#events.id === running?.id && this.#events.source.readyState !== EventSource.CLOSED) return;
    this.#close();
    if (!running) return;
    const source = new EventSource(eventsOf(running.id));
    this.#events = { id: running.id, source };
    source.onmessage = ({ data }: MessageEvent<string>) => {
      const job = JSON.parse(data) as Job;
      this.jobs = (this.jobs ?? []).map((other) => (other.id === job.id ? job : other));
      if (isOpen(job)) return;
      this.#close();
      this.#ended(job);
      void this.look();
    };
    source.onerror = () => {
      // The job has ended, or the server is gone: the next update shows which.
      this.#close();
    };
  }
}
