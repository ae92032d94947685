package simgsm.cells.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.abis.IpaConnection;
import simgsm.abis.IpaFrame;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.SpeechSocket;
import simgsm.cells.tower.TowerPort;
import simgsm.net.Datagrams;
import simgsm.timer.RateLimit;

/** The RSL link of one tower to its controller, and the UDP sockets of its channels' speech. */
final class TowerConnection extends IpaConnection implements TowerPort {
    private static final System.Logger LOG = System.getLogger(TowerConnection.class.getName());
    private static final int MOST_FRAMES = 20_000;

    private final CellsLoop cells;
    private final BaseStation tower;
    private final EndListener listener;
    private boolean wasInService;

    private record UdpSpeech(Datagrams socket) implements SpeechSocket {
        @Override
        public MediaAddress address() {
            return new MediaAddress(
                    socket.localAddress().getAddress().getHostAddress(),
                    socket.localAddress().getPort());
        }

        @Override
        public boolean connect(MediaAddress peer) {
            try {
                socket.connect(new InetSocketAddress(peer.host(), peer.port()));
                return true;
            } catch (IOException e) {
                LOG.log(Level.WARNING, "no speech to {0}: {1}", peer, e.getMessage());
                return false;
            }
        }

        @Override
        public void send(byte[] rtp) {
            socket.send(rtp);
        }

        @Override
        public void close() {
            socket.close();
        }
    }

    /** Receives the end of a connection. */
    interface EndListener {
        void ended(String reason, boolean wasInService);
    }

    TowerConnection(Endpoint endpoint, CellsLoop cells, BaseStation tower, EndListener listener) {
        super(endpoint, new RateLimit(Integer.MAX_VALUE, 1), MOST_FRAMES, written -> {});
        this.cells = cells;
        this.tower = tower;
        this.listener = listener;
    }

    @Override
    protected void opened() {
        cells.now();
        tower.connected(this);
    }

    @Override
    protected void frameArrived(IpaFrame frame) {
        cells.now();
        tower.frameArrived(frame);
    }

    @Override
    public Optional<SpeechSocket> openSpeech(Consumer<byte[]> received) {
        try {
            return Optional.of(new UdpSpeech(openDatagrams(rtp -> {
                cells.now();
                received.accept(rtp);
            })));
        } catch (IOException e) {
            LOG.log(Level.WARNING, "{0}: no UDP socket for speech: {1}", tower, e.getMessage());
            return Optional.empty();
        }
    }

    @Override
    public void drop(String reason) {
        fail(reason);
    }

    @Override
    protected void closing(boolean isByPeer) {
        super.closing(isByPeer);
        cells.now();
        wasInService = tower.isInService();
        tower.disconnected();
    }

    @Override
    protected void lost(String reason) {
        listener.ended(reason, wasInService);
    }
}
