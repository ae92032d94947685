package simrobot.source;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simrobot.behaviour.BehaviourRequest;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.process.Decision;
import simrobot.process.RobotProcess;
import simrobot.process.WaitBudget;
import simrobot.source.child.PipeLine;
import simrobot.source.child.PipeSenses;
import simrobot.source.child.RequestLine;

/**
 * The child of one version of a student's file: a process of the operating system that decides for all robots which run the
 * file. When it ends by a fault of one robot's behaviour, the others go on in a new one.
 *
 * <p>A robot hands over its senses every 50 ms of simulated time and takes the decision with the next: so the delay is the same
 * in every run. A decision that is late makes the robot brake. A simulation at its usual pace never waits here; one that is
 * faster waits for the decisions of all robots at most 50 ms a step, also for those that are already late, so that no robot
 * brakes for more periods than at the usual pace. One that waits for each is patient: there no decision is late, and a loaded
 * machine changes no pose.
 */
final class BehaviourChild implements ChildProcess.Listener {
    static final long PERIOD_NANOS = 50_000_000;

    /** A child ends a decision itself after 1 s; one that does not is ended after this time. */
    private static final long LATEST_NANOS = 3_000_000_000L;

    private static final int MOST_REQUESTS = 1000;
    private static final int MOST_KEPT = 20;

    /** A loaded machine needs seconds to start a Java virtual machine. */
    private static final long STARTING_NANOS = 10_000_000_000L;

    /** The exit status of a program that the terminal's Ctrl+C has ended, together with SimRobot. */
    private static final int INTERRUPTED = 130;

    private final ChildFile file;
    private final Consumer<Decision.Failed> startFault;
    /** Robots with an unanswered question, the oldest first. */
    private final Deque<OfRobot> asked = new ArrayDeque<>();
    /** Null while none runs. */
    private ChildProcess process;

    /** The newest lines. */
    private final Deque<String> last = new ArrayDeque<>();

    private OfRobot lastHeard;
    private long heardNanos;
    private int lastNumber;
    private int robots;
    /** True if the last line received states why the process ends. */
    private boolean isExplained;

    private boolean isReplaced;
    private boolean isClosed;

    /** @param startFault told why the process has ended before it was asked anything */
    BehaviourChild(ChildFile file, Consumer<Decision.Failed> startFault) {
        this.file = file;
        this.startFault = startFault;
    }

    ChildFile file() {
        return file;
    }

    /** Starts the process, so that the first decision does not wait for it. */
    synchronized void start() throws IOException {
        if (process == null && !isClosed) {
            lastHeard = null;
            asked.clear();
            last.clear();
            heardNanos = System.nanoTime() + STARTING_NANOS;
            process = new ChildProcess(file.name(), file.command(), this);
            file.lines().forEach(process::send);
            process.flush();
        }
    }

    /** A process of one robot. @param isPatient whether to wait for every decision */
    RobotProcess ofRobot(String className, WaitBudget budget, boolean isPatient) {
        return new OfRobot(className, budget, isPatient);
    }

    /** The file has a newer version: ends when the last robot has left. */
    synchronized void replace() {
        isReplaced = true;
        endIfLeft();
    }

    /** The file is gone, or SimRobot ends. */
    synchronized void close() {
        isClosed = true;
        kill();
    }

    private void endIfLeft() {
        if (isReplaced && robots == 0) {
            kill();
        }
    }

    private void kill() {
        if (process != null) {
            process.kill();
            process = null;
            notifyAll();
        }
    }

    synchronized boolean isRunning() {
        return process != null;
    }

    private static boolean isOf(OfRobot robot, PipeLine answer) {
        return answer.text("robot").equals(Integer.toString(robot.number));
    }

    @Override
    public synchronized void heard(ChildProcess from, String line) {
        Optional<PipeLine> answer = PipeLine.parse(line);
        // without a robot it is what an interpreter says of a file that it cannot execute
        last.add(line);
        if (last.size() > MOST_KEPT) {
            last.remove();
        }
        // one whose thread goes on between its decisions has none of the questions
        OfRobot robot = answer.flatMap(found ->
                        asked.stream().filter(each -> isOf(each, found)).findFirst())
                .or(() -> Optional.ofNullable(asked.isEmpty() ? lastHeard : asked.peek()))
                .orElse(null);
        if (robot == null || from != process) {
            return;
        }
        Optional<BehaviourRequest> request = answer.flatMap(RequestLine::parse);
        Optional<Decision> decision = answer.filter(found -> isOf(robot, found))
                .flatMap(found -> decision(found, robot))
                .or(() -> answer.filter(found -> isUnreadable(found, robot))
                        .map(found -> robot.failed(
                                0,
                                "go",
                                "expected go robot=" + robot.number + " speed=NUMBER turn=NUMBER, found " + line)));
        isExplained = decision.isPresent() && decision.get() instanceof Decision.Failed;
        if (decision.isPresent()) {
            robot.answer(decision.get());
        } else if (robot.requests.size() < MOST_REQUESTS) {
            robot.requests.add(request.orElseGet(() -> new BehaviourRequest.Printed(line + "\n")));
        }
    }

    /** Returns the decision that a line tells, with what the robot has asked for before; empty if it tells none. */
    private Optional<Decision> decision(PipeLine answer, OfRobot robot) {
        try {
            if (answer.word().equals("failed")) {
                int line = (int) answer.number("line");
                return Optional.of(robot.failed(line, answer.text("cause"), answer.text("text")));
            }
            if (!answer.word().equals("go")) {
                return Optional.empty();
            }
            Steering steering = new Steering(answer.number("speed"), answer.number("turn"));
            List<BehaviourRequest> requests = List.copyOf(robot.requests);
            return Optional.of(answer.flag("done") ? new Decision.Done(requests) : new Decision.Go(steering, requests));
        } catch (IllegalArgumentException malformed) {
            return Optional.empty();
        }
    }

    /** True for a decision without numbers, or of no robot; a second one of another robot is a print. */
    private static boolean isUnreadable(PipeLine answer, OfRobot robot) {
        return answer.word().equals("go")
                && answer.values().containsKey("speed")
                && (isOf(robot, answer) || !answer.text("robot").matches("[0-9]+"));
    }

    @Override
    public synchronized void ended(ChildProcess from, int status) {
        if (from != process) {
            return;
        }
        process = null;
        OfRobot culprit = asked.isEmpty() ? lastHeard : asked.peek();
        Decision.Failed fault = file.ended(status, last, culprit == null ? List.of() : culprit.requests);
        if (culprit == null) {
            startFault.accept(fault);
        } else if (!isExplained && status != INTERRUPTED) {
            culprit.answer(fault);
        }
        notifyAll();
    }

    /** Ends a process that answers nothing, which is the fault of the robot that was asked first. */
    private void endIfOverdue() {
        OfRobot oldest = asked.peek();
        long now = System.nanoTime();
        if (process != null
                && oldest != null
                && now - heardNanos > LATEST_NANOS
                && now - oldest.askedNanos > LATEST_NANOS) {
            oldest.answer(oldest.failed(0, "loops", "no decision within 3 s"));
            kill();
        }
    }

    /** The process of one robot. */
    private final class OfRobot implements RobotProcess {
        private final String className;
        private final WaitBudget budget;
        private final boolean isPatient;
        /** Null before the first question, and while it was asked in none that still runs. */
        private ChildProcess begun;

        private int number;
        private long askedNanos;
        /** End of the last wait for a decision. */
        private long awaitedNanos;
        /** Null until the child has decided. */
        private Decision answer;

        /** Requests of the current decision. */
        private final List<BehaviourRequest> requests = new ArrayList<>();

        private Decision last = new Decision.Go(Steering.STOP);
        private boolean isOpen = true;

        OfRobot(String className, WaitBudget budget, boolean isPatient) {
            this.className = className;
            this.budget = budget;
            this.isPatient = isPatient;
            synchronized (BehaviourChild.this) {
                robots++;
            }
        }

        /** True if the running child knows the robot. */
        private boolean isBegun() {
            return begun != null && begun == process;
        }

        private Decision failed(int line, String cause, String text) {
            return file.failed(line, cause, text, requests);
        }

        private void answer(Decision decided) {
            answer = decided;
            heardNanos = System.nanoTime();
            lastHeard = this;
            asked.remove(this);
            BehaviourChild.this.notifyAll();
        }

        @Override
        public long periodNanos() {
            return PERIOD_NANOS;
        }

        @Override
        public Decision decide(Senses senses) {
            synchronized (BehaviourChild.this) {
                if (isBegun() && answer == null) {
                    await();
                }
                boolean isLate = isBegun() && answer == null;
                if (isLate) {
                    endIfOverdue();
                }
                // without an answer none was asked, the child was ended for another robot, or it is late
                Decision now = answer == null ? new Decision.Go(Steering.STOP) : answer;
                if (isLate) {
                    return now;
                }
                last = now;
                return last instanceof Decision.End ? last : ask(senses);
            }
        }

        /** Returns the last decision, which is in force until there is an answer; or why the child cannot be asked. */
        private Decision ask(Senses senses) {
            try {
                start();
            } catch (IOException e) {
                return failed(0, "start", e.getMessage());
            }
            if (process == null) {
                return new Decision.Failed(0, "the file is not in the folder any more");
            }
            if (begun != process) {
                begun = process;
                number = ++lastNumber;
                process.send(PipeLine.of("begin", "robot", number, "class", className));
            }
            answer = null;
            requests.clear();
            askedNanos = System.nanoTime();
            asked.add(this);
            process.send(PipeSenses.line(number, senses, file.readsLaser()));
            budget.atEnd(process::flush);
            return last;
        }

        /** Waits until there is an answer, the child ends, or the time is over. */
        private void await() {
            long began = System.nanoTime();
            long end = isPatient
                    ? Math.max(heardNanos, askedNanos) + LATEST_NANOS
                    : Math.min(Math.max(askedNanos, awaitedNanos) + PERIOD_NANOS, began + budget.leftNanos());
            long left = end - began;
            try {
                while (answer == null && begun == process && left > 0) {
                    BehaviourChild.this.wait(left / 1_000_000, (int) (left % 1_000_000));
                    left = end - System.nanoTime();
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            awaitedNanos = System.nanoTime();
            budget.spend(awaitedNanos - began);
        }

        @Override
        public void close() {
            synchronized (BehaviourChild.this) {
                if (isOpen) {
                    isOpen = false;
                    robots--;
                    if (isBegun()) {
                        process.send(PipeLine.of("end", "robot", number));
                        process.flush();
                    }
                    endIfLeft();
                }
            }
        }
    }
}
