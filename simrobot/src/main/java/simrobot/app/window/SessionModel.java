package simrobot.app.window;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.thread.DaemonThread;
import simrobot.control.FileExports;
import simrobot.simulation.PacedThread;
import simrobot.ui.OperatorActions;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldPictures;
import simrobot.ui.inspector.RefusalTexts;

/**
 * The common parts of a running simulation and a recording for the window: pace, notices, exports, and a thread for
 * files.
 */
public abstract class SessionModel implements OperatorActions, AutoCloseable {
    private static final long NOTICE_NANOS = TimeUnit.SECONDS.toNanos(12);

    private final PacedThread session;
    private final RefusalTexts refusals;
    private final FileExports exports;
    /** Formats tracks, reads and writes files; ignores tasks once closed. */
    private final ThreadPoolExecutor worker = new ThreadPoolExecutor(
            1,
            1,
            0,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            acts -> DaemonThread.of("window worker", acts::run),
            new ThreadPoolExecutor.DiscardPolicy());

    private volatile String notice = "";
    private volatile long noticeNanos;
    private WindowSnapshot newest;

    SessionModel(PacedThread session, FileExports.Tracks tracks, RefusalTexts refusals) {
        this.session = session;
        this.refusals = refusals;
        exports = new FileExports(tracks, new WorldPictures());
    }

    final Executor worker() {
        return worker;
    }

    /** Closes the window's session: the worker ends after its queued tasks. */
    @Override
    public final void close() {
        worker.shutdown();
    }

    /** The newest snapshot; the same object until a change. For the event thread only. */
    public final WindowSnapshot snapshot() {
        WindowSnapshot now = observe();
        if (!now.equals(newest)) {
            newest = now;
        }
        return newest;
    }

    abstract WindowSnapshot observe();

    /** The notice of the last 12 s. */
    final String notice(String otherwise) {
        return System.nanoTime() - noticeNanos < NOTICE_NANOS ? notice : otherwise;
    }

    @Override
    public final void tell(String message) {
        noticeNanos = System.nanoTime();
        notice = message;
    }

    @Override
    public final void setSpeed(double simulatedSecondsPerSecond) {
        session.setSpeed(simulatedSecondsPerSecond);
    }

    @Override
    public final void setPaused(boolean paused) {
        session.setPaused(paused);
    }

    @Override
    public final void stepOnce() {
        session.stepOnce();
    }

    /** Exports the current moment as a picture, or the whole track. */
    @Override
    public final void export(String robot, Path file, Consumer<Optional<String>> answer) {
        exports.export(
                session.snapshot(),
                robot,
                file,
                worker,
                failure -> answer.accept(failure.map(why -> refusals.unwritable(file, why))));
    }
}
