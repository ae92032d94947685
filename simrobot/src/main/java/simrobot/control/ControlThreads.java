package simrobot.control;

import java.util.Objects;
import java.util.concurrent.Executor;
import java.util.function.LongSupplier;

/**
 * Who moves a robot and its modem on: two threads and the machine's clock in the program, one hand in a test.
 *
 * @param stations runs acts on the thread that owns the modem's station, in their order
 * @param simulation runs acts on the thread that owns the robot, in their order
 * @param clockNanos for measuring only
 */
public record ControlThreads(Executor stations, Executor simulation, LongSupplier clockNanos) {
    public ControlThreads {
        Objects.requireNonNull(stations);
        Objects.requireNonNull(simulation);
        Objects.requireNonNull(clockNanos);
    }
}
