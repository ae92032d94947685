package simrobot.app.window;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simrobot.control.FileExports;
import simrobot.simulation.PacedThread;
import simrobot.ui.OperatorActions;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldPictures;
import simrobot.ui.inspector.RefusalTexts;

/** What a running simulation and a recording have in common for the window: pace, notices, exports, and a thread for files. */
public abstract class SessionModel implements OperatorActions, AutoCloseable {
    private static final long NOTICE_NANOS = TimeUnit.SECONDS.toNanos(12);

    private final PacedThread session;
    private final RefusalTexts refusals;
    private final FileExports exports;
    /** Formats tracks, reads and writes files; once closed, it ignores what is asked. */
    private final ThreadPoolExecutor worker = new ThreadPoolExecutor(
            1,
            1,
            0,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            SessionModel::daemon,
            new ThreadPoolExecutor.DiscardPolicy());

    private volatile String notice = "";
    private volatile long noticeNanos;
    private WindowSnapshot newest;

    SessionModel(PacedThread session, FileExports.Tracks tracks, RefusalTexts refusals) {
        this.session = session;
        this.refusals = refusals;
        exports = new FileExports(tracks, new WorldPictures());
    }

    private static Thread daemon(Runnable acts) {
        Thread thread = new Thread(acts, "window worker");
        thread.setDaemon(true);
        return thread;
    }

    final Executor worker() {
        return worker;
    }

    /** Ends the worker once it has performed what was asked; the window has been closed. */
    @Override
    public final void close() {
        worker.shutdown();
    }

    /** The newest snapshot; the same object as long as nothing has changed. For the event thread only. */
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

    /** Pictures show the current moment; the track of a recording goes from its beginning to its end. */
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
