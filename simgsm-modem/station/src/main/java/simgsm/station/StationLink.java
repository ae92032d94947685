package simgsm.station;

import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.util.concurrent.TimeUnit;
import simgsm.abis.IpaConnection;
import simgsm.abis.IpaFrame;
import simgsm.net.Connection;
import simgsm.net.Connector;
import simgsm.net.LineAddress;
import simgsm.net.SelectorLoop;
import simgsm.station.context.StationLog;
import simgsm.station.context.Uplink;
import simgsm.timer.RateLimit;
import simgsm.timer.Timer;

/** One station and its connection to the centre, renewed whenever it is lost. Belongs to the stations' thread. */
final class StationLink implements Connector.Listener {
    private static final int MOST_SIGNALLING_FRAMES = 10_000;
    /** Longest wait of a departing station for the end of its detach procedure. */
    private static final long DEPARTURE_NANOS = TimeUnit.SECONDS.toNanos(1);

    private static final long DEPARTURE_CHECK_NANOS = TimeUnit.MILLISECONDS.toNanos(1);

    private final SelectorLoop loop;
    private final MobileStation station;
    private final Connector connector;
    private final String address;
    private final StationLog log;
    private final DisplacementWatch displacements = new DisplacementWatch();
    /** Null without a connection. */
    private Uplinked connection;

    private long connectedNanos;

    private boolean isAbsenceLogged;
    /** Runs when the station has departed; null before it departs. */
    private Runnable departed;

    private long departureNanos;

    /** Runs the station's timers; null before the first. */
    private Timer wake;

    private long wakeNanos;

    private final class Uplinked extends IpaConnection implements Uplink {
        Uplinked(Endpoint endpoint) {
            super(endpoint, new RateLimit(Integer.MAX_VALUE, 1), MOST_SIGNALLING_FRAMES, written -> {});
        }

        @Override
        protected void opened() {
            isAbsenceLogged = false;
            connectedNanos = System.nanoTime();
            log.trace(Level.INFO, "connected to the centre at {0}", address);
            station.linkUp(this, System.nanoTime());
        }

        @Override
        protected void frameArrived(IpaFrame frame) {
            station.frameArrived(frame, System.nanoTime());
        }

        @Override
        public void drop() {
            fail("ended by the station");
        }

        @Override
        protected void closing(boolean isByPeer) {
            super.closing(isByPeer);
            connection = null;
            // Towers end the links of all their terminals when the centre is lost.
            boolean isOfTower = station.snapshot().cell().isPresent();
            if (isByPeer && station.snapshot().registered() && !isOfTower) {
                connector.postpone(displacements.linkEnded(System.nanoTime() - connectedNanos));
                tellDisplacement();
            } else {
                displacements.reset();
            }
        }

        @Override
        protected void lost(String reason) {
            log.trace(Level.WARNING, "the connection to the centre is lost ({0}); trying again", reason);
            station.linkDown(System.nanoTime());
        }
    }

    /** Makes the first attempt to connect. */
    StationLink(SelectorLoop loop, MobileStation station, InetSocketAddress center) {
        this.loop = loop;
        this.station = station;
        station.onEarlierDeadline(this::armWake);
        armWake();
        address = LineAddress.of(center).toString();
        log = new StationLog(station.identity());
        connector = new Connector(loop, center, this);
        connector.start();
    }

    @Override
    public Connection connected(Connection.Endpoint endpoint) {
        connection = new Uplinked(endpoint);
        return connection;
    }

    private void tellDisplacement() {
        if (displacements.isNews()) {
            log.trace(
                    Level.WARNING,
                    "the centre ends the link after each registration: another terminal seems to use this number and IMEI {0}; trying again after pauses of up to 60 s",
                    station.identity().imei().digits());
        }
    }

    @Override
    public void failed(String reason) {
        displacements.reset();
        if (!isAbsenceLogged) {
            isAbsenceLogged = true;
            log.trace(Level.WARNING, "no centre at {0} ({1}); trying again", address, reason);
        }
        station.linkDown(System.nanoTime());
    }

    private void armWake() {
        long next = station.nextDeadlineNanos();
        if (wake == null || !wake.isRunning() || next < wakeNanos) {
            loop.cancel(wake);
            wakeNanos = next;
            wake = next == MobileStation.NO_DEADLINE ? null : loop.after(next - System.nanoTime(), this::wake);
        }
    }

    private void wake() {
        try {
            station.timePassed(System.nanoTime());
        } finally {
            armWake();
        }
    }

    MobileStation station() {
        return station;
    }

    /** Detaches the station. @param whenDeparted runs after the last sign of the station, in a later action of the loop */
    void depart(Runnable whenDeparted) {
        if (departed == null) {
            departed = whenDeparted;
            departureNanos = System.nanoTime();
            station.powerOff();
            loop.after(0, this::closeIfDeparted);
        }
    }

    /** The station has departed when it has detached and all its frames are written, or at the time-out. */
    private void closeIfDeparted() {
        boolean isFlushed = connection == null || !connection.hasOutput();
        if (isFlushed && station.isDetached() || System.nanoTime() - departureNanos >= DEPARTURE_NANOS) {
            close();
        } else {
            loop.after(DEPARTURE_CHECK_NANOS, this::closeIfDeparted);
        }
    }

    /** Stops attempts to connect. */
    void close() {
        station.onEarlierDeadline(() -> {});
        loop.cancel(wake);
        connector.close();
        if (departed != null) {
            departed.run();
        }
    }
}
