package simgsm.modem.at.port;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simgsm.modem.at.command.AtClient;
import simgsm.modem.at.command.AtModem;
import simgsm.net.Acceptor;
import simgsm.net.Connection;
import simgsm.net.ConnectionLimits;
import simgsm.net.FirstExchange;
import simgsm.net.OutputQueue;
import simgsm.net.QueuedConnection;
import simgsm.station.MobileStation;
import simgsm.station.StationThread;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timers;

/**
 * A TCP port for AT commands to one terminal; up to 8 clients at a time, each with its own settings. It belongs to
 * the thread of the terminal's station, and is also its clock.
 */
public final class AtPort implements AutoCloseable {
    private static final int MOST_CLIENTS = 8;
    /** Most answers and codes waiting for a client; one that does not read loses its connection. */
    private static final int MOST_WAITING = 10_000;

    private static final int MOST_FRAMES = 10;

    /** Most delay of a timer started between two ticks. */
    private static final long MOST_WAIT_NANOS = 250_000_000;
    /** Longest wait of a client for the result of its last command. */
    private static final long LAST_RESULT_NANOS = 10_000_000_000L;

    private final AtModem modem;
    private final MobileStation station;
    private final StationThread thread;
    private final InetAddress address;
    private final Acceptor acceptor;
    private Optional<Acceptor> audio = Optional.empty();
    private final Set<Connection> connections = new HashSet<>();
    private final long originNanos = System.nanoTime();

    private final class ClientConnection extends QueuedConnection {
        private AtClient client;
        private boolean isInputEnded;

        ClientConnection(Endpoint endpoint) {
            super(endpoint, new OutputQueue(MOST_WAITING, 0, written -> {}));
        }

        @Override
        protected void opened() {
            connections.add(this);
            advance();
            client = modem.connect(this::send);
            tick();
        }

        private void send(byte[] octets) {
            if (!writeLater(octets, false)) {
                fail("the client does not read");
            }
            endAfterLastResult();
        }

        /** A client such as {@code printf ... | socat} ends its output and then reads the result. */
        @Override
        protected boolean outlivesInput() {
            isInputEnded = client.isPerforming();
            if (isInputEnded) {
                after(LAST_RESULT_NANOS, () -> fail(CLOSED_BY_PEER));
            }
            return isInputEnded;
        }

        private void endAfterLastResult() {
            if (isInputEnded) {
                after(0, () -> {
                    if (!client.isPerforming() && output().isEmpty()) {
                        fail(CLOSED_BY_PEER);
                    }
                });
            }
        }

        /** Gives the modem its time while a client is connected: each connection wakes itself at the next deadline. */
        private void tick() {
            advanceAll();
            Timers timers = modem.timers();
            long wait = timers.nextDeadlineNanos().isPresent()
                    ? timers.nextDeadlineNanos().getAsLong() - timers.nowNanos()
                    : MOST_WAIT_NANOS;
            after(Math.min(wait, MOST_WAIT_NANOS), this::tick);
        }

        @Override
        protected void received(ByteBuffer octets) {
            byte[] all = new byte[octets.remaining()];
            octets.get(all);
            advanceAll();
            client.received(all);
        }

        @Override
        protected boolean wantsInput() {
            return client == null || client.wantsInput();
        }

        @Override
        protected void closing(boolean isByPeer) {
            connections.remove(this);
            if (client != null) {
                client.close();
            }
        }
    }

    /** The client's program for the sound; it loses the oldest of more than 200 ms that it has not read. */
    private final class SoundConnection extends QueuedConnection {
        SoundConnection(Endpoint endpoint) {
            super(endpoint, new OutputQueue(0, MOST_FRAMES, written -> {}));
        }

        @Override
        protected void opened() {
            connections.add(this);
            modem.sound().connect(frame -> write(frame, true));
        }

        @Override
        protected void received(ByteBuffer octets) {
            byte[] all = new byte[octets.remaining()];
            octets.get(all);
            modem.sound().received(all);
        }

        @Override
        protected void closing(boolean isByPeer) {
            connections.remove(this);
            modem.sound().disconnect();
        }
    }

    private AtPort(AtModem modem, MobileStation station, StationThread thread, InetSocketAddress address)
            throws IOException {
        this.address = address.getAddress();
        this.modem = modem;
        this.station = station;
        this.thread = thread;
        acceptor = thread.listen(
                address, new ConnectionLimits(MOST_CLIENTS, MOST_CLIENTS), endpoint -> new ClientConnection(endpoint));
    }

    /**
     * Opens a port; it is served once the thread runs.
     *
     * @param station of the modem's terminal
     * @param thread owns the station
     * @throws IOException naming address and port
     */
    public static AtPort open(AtModem modem, MobileStation station, StationThread thread, InetSocketAddress address)
            throws IOException {
        return new AtPort(modem, station, thread, address);
    }

    /**
     * Opens a port for the sound of calls; one client at a time.
     *
     * @return its number
     * @throws IOException naming address and port
     */
    public int openAudio(InetSocketAddress place) throws IOException {
        audio = Optional.of(thread.listen(place, new ConnectionLimits(1, 1), SoundConnection::new));
        thread.execute(modem.sound()::offer);
        return audio.get().port();
    }

    public int port() {
        return acceptor.port();
    }

    /** Exchanges one command with itself, once the thread runs. */
    public void exchangeFirst() {
        FirstExchange.with(address, port(), "AT\r".getBytes(StandardCharsets.US_ASCII));
    }

    /** Receives each event of the terminal's station, on its thread. */
    public void accept(StationEvent event) {
        advance();
        modem.accept(event);
    }

    /** Commands act at the station's time, possibly that of its last frame. */
    private void advanceAll() {
        station.timePassed(System.nanoTime());
        advance();
    }

    private void advance() {
        modem.timers().advance(System.nanoTime() - originNanos);
    }

    /** Closes the port and, on the station's thread, the connections of its clients. */
    @Override
    public void close() {
        acceptor.close();
        audio.ifPresent(Acceptor::close);
        thread.execute(() -> List.copyOf(connections).forEach(Connection::dismiss));
    }
}
