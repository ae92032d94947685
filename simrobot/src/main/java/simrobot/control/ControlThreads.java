package simrobot.control;

import java.util.concurrent.Executor;
import java.util.function.LongSupplier;

/**
 * The executors and the clock of a robot and its modem: two threads and the system clock in the program, one thread in
 * a test.
 *
 * @param stations runs tasks in order on the thread that owns the modem's station
 * @param simulation runs tasks in order on the thread that owns the robot
 * @param clockNanos monotonic clock for measurements and the time limit of replies to messages
 */
public record ControlThreads(Executor stations, Executor simulation, LongSupplier clockNanos) {}
