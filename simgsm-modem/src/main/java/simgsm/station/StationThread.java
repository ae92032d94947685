package simgsm.station;

import java.net.InetSocketAddress;

/**
 * The one thread that gives one or many stations their time and their sockets. It connects each to its centre, at once and
 * then again with pauses that grow from 0.2 s to 5 s, and owns the stations until it is closed.
 */
public final class StationThread implements AutoCloseable {
    /** Not started yet. */
    public StationThread(String name) {
        throw new UnsupportedOperationException();
    }

    /** Starts the thread. */
    public void start() {
        throw new UnsupportedOperationException();
    }

    /** Takes over a station and keeps it connected. Any thread may call it, before or after {@link #start}. */
    public void add(MobileStation station, InetSocketAddress center) {
        throw new UnsupportedOperationException();
    }

    /**
     * Has the act done by the owner thread, in order; the stations' time is now when it runs. Any thread may call it. An act
     * that throws is logged and the thread goes on. After the close it is dropped.
     */
    public void execute(Runnable act) {
        throw new UnsupportedOperationException();
    }

    /** Speech frames that were dropped because the centre did not take them within 200 ms. */
    public long droppedSpeechFrames() {
        throw new UnsupportedOperationException();
    }

    /** Detaches the stations, writes what is still to be written (for at most a second) and ends the thread. */
    @Override
    public void close() {
        throw new UnsupportedOperationException();
    }
}
