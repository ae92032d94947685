package simgsm.gateway.sip;

import java.util.function.BiConsumer;
import simgsm.station.MobileStation;

/** The core's surroundings: datagrams, and the link of each station to the network. */
public interface SipTransport {
    /** A socket for the speech of one call. */
    interface Media {
        int port();

        void send(byte[] octets, SipPeer to);

        void close();
    }

    /** Moves the timers to the present, before an event of a station: its thread may have waited since the last datagram. */
    void timePassed();

    /** Sends a SIP message; it may be lost. */
    void send(byte[] octets, SipPeer to);

    /** This machine's address as seen by a peer. */
    String hostTowards(SipPeer peer);

    /** The port of SIP messages. */
    int port();

    /**
     * Opens a socket for speech.
     *
     * @param received takes each datagram and its source
     * @return null if the system gives no port
     */
    Media openMedia(BiConsumer<byte[], SipPeer> received);

    /** Connects a station to the network. */
    void add(MobileStation station);

    /** Detaches a station. @param gone runs after its last sign */
    void remove(MobileStation station, Runnable gone);
}
