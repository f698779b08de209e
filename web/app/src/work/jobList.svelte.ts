// The jobs of the folder, followed while a screen shows them.

import { eventsOf, isOpen, listJobs, type Job } from "../api/jobs";

/** Time between two looks at the whole list, ms: other tabs start jobs, too. */
const LOOK_MS = 4000;

export class JobList {
  jobs = $state.raw<Job[] | null>(null);
  problem = $state.raw<unknown>(null);
  #events: { id: string; source: EventSource } | null = null;
  #ended: (job: Job) => void;

  /** `ended` is told of each job that ends while it is followed. */
  constructor(ended: (job: Job) => void = () => {}) {
    this.#ended = ended;
  }

  /** Follows them until what it gives is called; return it from an effect. */
  follow(): () => void {
    void this.look();
    const timer = setInterval(() => void this.look(), LOOK_MS);
    return () => {
      clearInterval(timer);
      this.#close();
    };
  }

  /** Looks at the whole list now. */
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

  /** One job goes on at a time: that is the one whose events are wanted. */
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
      // Over, or the server is gone: the next look says which.
      this.#close();
    };
  }
}
