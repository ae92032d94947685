package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Queue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simrobot.robot.SimulatedRobot;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;

@Timeout(30)
class SimulationThreadTest {
    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final SimulatedRobot robot = simulation.addRobot("robot");
    private final SimulationThread thread = new SimulationThread(simulation);

    @BeforeEach
    void start() {
        thread.start();
    }

    @AfterEach
    void end() {
        thread.close();
    }

    private <T> T ask(Supplier<T> question) throws Exception {
        CompletableFuture<T> answer = new CompletableFuture<>();
        thread.post(() -> answer.complete(question.get()));
        return answer.get(20, TimeUnit.SECONDS);
    }

    @Test
    void actsAreDoneOnTheOwnerThreadInTheirOrder() throws Exception {
        StringBuilder order = new StringBuilder();
        thread.post(() -> order.append('a'));
        thread.post(() -> order.append('b'));
        assertEquals("ab", ask(order::toString));
        assertTrue(ask(thread::isOwner));
        assertFalse(thread.isOwner());
    }

    @Test
    void aMotionEndsWithoutSteppingByHand() throws Exception {
        thread.setSpeed(SimulationThread.AS_FAST_AS_IT_CAN);
        CompletableFuture<MotionOutcome> ended = new CompletableFuture<>();
        thread.post(() -> robot.start(new Instruction.Forward(1000), ended::complete));
        assertEquals(MotionOutcome.Ending.DONE, ended.get(20, TimeUnit.SECONDS).ending());
    }

    @Test
    void aPausedSimulationMovesByTheSingleStepsThatAreAskedFor() throws Exception {
        thread.setPaused(true);
        long before = ask(simulation::timeNanos);
        thread.stepOnce();
        thread.stepOnce();
        assertEquals(before + 2 * Simulation.STEP_NANOS, ask(simulation::timeNanos));
        assertTrue(thread.isPaused());
    }

    @Test
    void aFaultyActDoesNotStopTheRobots() throws Exception {
        thread.post(() -> {
            throw new IllegalStateException("a fault made by a test");
        });
        thread.setSpeed(50);
        CountDownLatch moving = new CountDownLatch(20);
        thread.post(() -> simulation.addStepListener(now -> moving.countDown()));
        assertTrue(moving.await(20, TimeUnit.SECONDS));
    }

    @Test
    void askingForAPictureMakesTheNextOneNewer() throws Exception {
        thread.setSpeed(20);
        SimulationSnapshot first = thread.snapshot();
        CountDownLatch newer = new CountDownLatch(1);
        thread.post(() -> simulation.addStepListener(now -> {
            if (thread.snapshot().timeNanos() > first.timeNanos()) {
                newer.countDown();
            }
        }));
        assertTrue(newer.await(20, TimeUnit.SECONDS));
    }

    @Test
    void speedIsAboveZero() {
        assertThrows(IllegalArgumentException.class, () -> thread.setSpeed(0));
        assertThrows(IllegalArgumentException.class, () -> thread.setSpeed(Double.NaN));
    }

    @Test
    void aFaultThatEndsTheSimulationIsReportedAndClosingIsStillFine() throws Exception {
        CompletableFuture<Throwable> told = new CompletableFuture<>();
        thread.onFailure(told::complete);
        thread.post(() -> {
            throw new AssertionError("a fault made by a test");
        });
        assertEquals("a fault made by a test", told.get(20, TimeUnit.SECONDS).getMessage());
        thread.close();
    }

    private static final class FailingSteps implements LongConsumer {
        private final AtomicInteger calls = new AtomicInteger();

        @Override
        public void accept(long nanos) {
            calls.incrementAndGet();
            throw new IllegalStateException("a fault made by a test");
        }
    }

    @Test
    void aStepThatFailsEndsTheSimulationAtOnceAndIsReportedOnce() throws Exception {
        Queue<Throwable> told = new ConcurrentLinkedQueue<>();
        CountDownLatch ended = new CountDownLatch(1);
        thread.onFailure(fault -> {
            told.add(fault);
            ended.countDown();
        });
        FailingSteps steps = new FailingSteps();
        thread.withSimulation(owned -> owned.addStepListener(steps));
        assertTrue(ended.await(20, TimeUnit.SECONDS));
        thread.close();
        assertEquals(1, steps.calls.get());
        assertEquals(
                List.of("a fault made by a test"),
                told.stream().map(Throwable::getMessage).toList());
    }

    @Test
    void manyStepsLetOtherActsPassAndReportTheirEnd() throws Exception {
        CompletableFuture<Long> passed = new CompletableFuture<>();
        thread.setPaused(true);
        long before = ask(simulation::timeNanos);
        thread.withSimulation(owned ->
                owned.addStepListener(time -> thread.post(() -> passed.complete(simulation.timeNanos() - before))));
        thread.steps(10_000).get(20, TimeUnit.SECONDS);
        assertEquals(before + 10_000 * Simulation.STEP_NANOS, ask(simulation::timeNanos));
        assertTrue(passed.get(20, TimeUnit.SECONDS) <= 100 * Simulation.STEP_NANOS, "after " + passed.get());
    }

    @Test
    void stepsOfAThreadThatEndsAreCancelled() {
        thread.setPaused(true);
        thread.withSimulation(owned -> owned.addStepListener(time -> thread.post(thread::close)));
        CompletableFuture<Void> steps = thread.steps(10_000);
        assertThrows(CancellationException.class, () -> steps.get(20, TimeUnit.SECONDS));
    }

    @Test
    void aSingleStepThatFailsEndsTheSimulationToo() throws Exception {
        CompletableFuture<Throwable> told = new CompletableFuture<>();
        thread.onFailure(told::complete);
        thread.setPaused(true);
        thread.withSimulation(owned -> owned.addStepListener(new FailingSteps()));
        thread.stepOnce();
        assertEquals("a fault made by a test", told.get(20, TimeUnit.SECONDS).getMessage());
    }

    @Test
    void closingTwiceIsFine() {
        thread.close();
        thread.close();
    }
}
