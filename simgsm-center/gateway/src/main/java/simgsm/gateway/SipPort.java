package simgsm.gateway;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.security.SecureRandom;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import simgsm.air.Msisdn;
import simgsm.gateway.sip.SipListener;
import simgsm.gateway.sip.SipPeer;
import simgsm.gateway.sip.SipServer;
import simgsm.gateway.sip.SipTransport;
import simgsm.net.Datagrams;
import simgsm.station.MobileStation;
import simgsm.station.StationThread;

/** Gives the SIP core its UDP sockets and its time. Belongs to the stations' thread. */
final class SipPort implements SipTransport, SipListener {
    private static final System.Logger LOG = System.getLogger(SipPort.class.getName());
    private static final int MOST_KNOWN_HOSTS = 10_000;

    private final StationThread thread;
    private final GatewaySettings settings;
    private final Consumer<GatewayEvent> listener;
    private final Datagrams socket;
    private final CoreTime time;
    private final SipServer server;
    /** Addresses of this machine, by that of a peer. */
    private final Map<String, String> hosts = new HashMap<>();

    /** @throws IOException if the port cannot be opened */
    SipPort(StationThread thread, GatewaySettings settings, Consumer<GatewayEvent> listener) throws IOException {
        this.thread = thread;
        this.settings = settings;
        this.listener = listener;
        time = new CoreTime(thread);
        server = new SipServer(
                time.timers(), this, settings.sipUsers(), RandomGenerator.getDefault(), new SecureRandom(), this);
        socket = thread.datagrams(
                new InetSocketAddress(settings.bind(), settings.sip().orElseThrow()),
                (octets, from) -> thread.execute(() -> {
                    time.advance();
                    server.arrived(octets, peer(from));
                }));
    }

    SipServer server() {
        return server;
    }

    private static SipPeer peer(InetSocketAddress address) {
        return new SipPeer(address.getAddress().getHostAddress(), address.getPort());
    }

    @Override
    public void timePassed() {
        time.advance();
    }

    @Override
    public void send(byte[] octets, SipPeer to) {
        socket.send(octets, new InetSocketAddress(to.host(), to.port()));
    }

    @Override
    public String hostTowards(SipPeer peer) {
        if (!settings.bind().isAnyLocalAddress()) {
            return settings.bind().getHostAddress();
        }
        if (hosts.size() > MOST_KNOWN_HOSTS) {
            hosts.clear();
        }
        return hosts.computeIfAbsent(peer.host(), host -> {
            // connecting a UDP socket sends nothing; the system chooses the local address
            try (DatagramSocket probe = new DatagramSocket()) {
                probe.connect(InetAddress.getByName(host), peer.port());
                return probe.getLocalAddress().getHostAddress();
            } catch (IOException | RuntimeException e) {
                return InetAddress.getLoopbackAddress().getHostAddress();
            }
        });
    }

    @Override
    public int port() {
        return socket.localAddress().getPort();
    }

    @Override
    public Media openMedia(BiConsumer<byte[], SipPeer> received) {
        try {
            Datagrams speech = thread.datagrams(new InetSocketAddress(settings.bind(), 0), (octets, from) -> {
                time.advance();
                received.accept(octets, peer(from));
            });
            return new Media() {
                @Override
                public int port() {
                    return speech.localAddress().getPort();
                }

                @Override
                public void send(byte[] octets, SipPeer to) {
                    speech.send(octets, new InetSocketAddress(to.host(), to.port()));
                }

                @Override
                public void close() {
                    speech.close();
                }
            };
        } catch (IOException e) {
            LOG.log(Level.WARNING, "SIP: {0}", e.getMessage());
            return null;
        }
    }

    @Override
    public void add(MobileStation station) {
        thread.add(station, settings.center());
    }

    @Override
    public void remove(MobileStation station, Runnable gone) {
        thread.remove(station, gone);
    }

    @Override
    public void joined(Msisdn number, String from) {
        listener.accept(new GatewayEvent.Joined(GatewayEvent.SIP, number, from, Optional.empty()));
    }

    @Override
    public void left(Msisdn number) {
        listener.accept(new GatewayEvent.Left(GatewayEvent.SIP, number));
    }

    @Override
    public void refused(String from, int status, String text) {
        listener.accept(new GatewayEvent.Refused(GatewayEvent.SIP, from, status, text));
    }
}
