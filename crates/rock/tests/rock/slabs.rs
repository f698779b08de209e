//! The same rock whoever works on it.

use std::sync::atomic::{AtomicUsize, Ordering};

use wholestring_rock::{Alone, Block, Executor, Stepper};

use crate::drill::{self, Ball};

const STEPS: usize = 2500;

/// Works on the last piece first.
struct Backwards;

impl Executor for Backwards {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..count).rev().for_each(work);
    }
}

/// Three threads.
struct Threads;

impl Executor for Threads {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        let next = AtomicUsize::new(0);
        std::thread::scope(|scope| {
            for _ in 0..3 {
                scope.spawn(|| {
                    loop {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        if index >= count {
                            break;
                        }
                        work(index);
                    }
                });
            }
        });
    }
}

fn drilled(stepper: &Stepper, executor: &impl Executor, steps: usize) -> Block {
    let (mut block, mut ball) = (drill::block(), Ball::new());
    for _ in 0..steps {
        ball.drag(&mut block, stepper, executor);
    }
    block
}

#[test]
fn the_rock_is_the_same_whoever_works_on_it() {
    let stepper = Stepper::default();
    let bits = |block: &Block| postcard::to_allocvec(block).expect("plain data");
    let alone = drilled(&stepper, &Alone, STEPS);
    assert!(alone.removed().0 > 0);
    assert_eq!(bits(&alone), bits(&drilled(&stepper, &Backwards, STEPS)));
    assert_eq!(bits(&drilled(&stepper, &Alone, 300)), bits(&drilled(&stepper, &Threads, 300)));
}

/// Threads of a pool do every piece once, and give the same rock.
#[cfg(feature = "rayon")]
#[test]
fn the_threads_of_a_pool_come_to_the_same_rock() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("threads");
    let counts: Vec<AtomicUsize> = (0..100).map(|_| AtomicUsize::new(0)).collect();
    for _ in 0..50 {
        pool.each(counts.len(), &|index| {
            counts[index].fetch_add(1, Ordering::Relaxed);
        });
    }
    assert!(counts.iter().all(|count| count.load(Ordering::Relaxed) == 50));
    let stepper = Stepper::default();
    let bits = |block: &Block| postcard::to_allocvec(block).expect("plain data");
    assert_eq!(bits(&drilled(&stepper, &Alone, 300)), bits(&drilled(&stepper, &pool, 300)));
}

#[test]
fn a_block_goes_on_from_its_bytes() {
    let stepper = Stepper::default();
    let (mut block, mut ball) = (drill::block(), Ball::new());
    for _ in 0..STEPS {
        ball.drag(&mut block, &stepper, &Alone);
    }
    let bytes = postcard::to_allocvec(&block).expect("plain data");
    let mut copy: Block = postcard::from_bytes(&bytes).expect("a block");
    for _ in 0..10 {
        block.step(&stepper, &Alone);
        copy.step(&stepper, &Alone);
    }
    let bits = |block: &Block| postcard::to_allocvec(block).expect("plain data");
    assert_eq!(bits(&block), bits(&copy));
}

/// Instruction sets of different width, to the last bit.
#[test]
fn all_instructions_give_the_same_rock() {
    let all: Vec<_> = Stepper::all()
        .iter()
        .map(|stepper| (stepper.instructions, drilled(stepper, &Alone, 400)))
        .collect();
    let bits = |block: &Block| postcard::to_allocvec(block).expect("plain data");
    let (_, first) = &all[0];
    for (name, other) in &all {
        assert!(bits(other) == bits(first), "{name}");
    }
}

/// An executor that leaves out work is found out.
#[test]
#[should_panic(expected = "the executor left work undone")]
fn work_that_is_left_undone_is_noticed() {
    struct Lazy;
    impl Executor for Lazy {
        fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
            (1..count).for_each(work);
        }
    }
    drill::block().step(&Stepper::default(), &Lazy);
}
