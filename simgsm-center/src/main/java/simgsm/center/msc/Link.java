package simgsm.center.msc;

import java.lang.System.Logger.Level;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.KeepAlive;
import simgsm.abis.RslCodec;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.ShortMessageControl;
import simgsm.center.subscriber.Subscriber;
import simgsm.octets.OctetString;
import simgsm.timer.Timer;
import simgsm.timer.Timers;
import simgsm.trace.MessageText;

/**
 * One terminal's connection: the terminal with the small cell that it carries. To the driver a mere handle; inside, all
 * that the exchange knows of the terminal at the other end.
 */
public final class Link {
    /** So many breaches are answered as the standard says before the peer is given up. */
    static final int MAX_VIOLATIONS = 100;

    /** How long a peer may take to identify itself or to register; a port scanner does neither. */
    static final long IDENTITY_NANOS = Duration.ofSeconds(15).toNanos();

    private static final int LOUD_VIOLATIONS = 3;
    private static final System.Logger LOG = System.getLogger(Link.class.getName());

    final LinkPort port;
    private final ExchangeParts parts;
    final Timers timers;
    final NetworkRadioConnection radio;
    final Paging paging;
    private final KeepAlive keepAlive;
    final Authenticity authenticity;
    final TerminalRateLimits moderation;
    final ShortMessageTransfers shortMessages;
    final List<CallLeg> callLegs = new ArrayList<>(2);

    private final String address;

    /** Who is registered here; null until the location update has ended well, and after detach. */
    Subscriber subscriber;
    /** The location update under way, or null. */
    LocationUpdate registration;

    boolean isClosed;
    private Timer identification;
    private String lifeline;
    private int violations;

    Link(LinkPort port, String address, boolean isLocal, ExchangeParts parts) {
        this.port = port;
        this.address = address;
        this.lifeline = address;
        this.parts = parts;
        this.timers = parts.timers().ownedBy(this::failed);
        this.radio = new NetworkRadioConnection(this, timers);
        this.paging = new Paging(this, timers);
        this.keepAlive = new KeepAlive(timers, this::sendCcm, this::drop);
        this.moderation = new TerminalRateLimits(isLocal, timers);
        this.authenticity = new Authenticity(this, timers);
        this.shortMessages = new ShortMessageTransfers(this, timers, parts.shortMessageCenter());
    }

    /** Asks the peer for its identity and begins to supervise the connection. */
    void open() {
        sendCcm(new CcmMessage.IdentityRequest());
        keepAlive.start();
        identification = timers.start(IDENTITY_NANOS, () -> drop("has not identified itself"));
    }

    void receive(CcmMessage message) {
        if (message instanceof CcmMessage.IdentityResponse) {
            timers.cancel(identification);
            sendCcm(new CcmMessage.IdentityAcknowledge());
        } else {
            keepAlive.receive(message);
        }
    }

    /** The subscriber's number, or the peer's address while nobody is registered. */
    String name() {
        return subscriber == null ? address : subscriber.number().digits();
    }

    /** From now on somebody is registered here. */
    void become(Subscriber who) {
        subscriber = who;
        timers.cancel(identification);
        lifeline = who.number().digits();
    }

    /** As {@link #name}, but a number that was registered here once stays when its subscriber has left. */
    String lifeline() {
        return lifeline;
    }

    /** Whether anybody has ever been registered here. */
    boolean hasNumber() {
        return !lifeline.equals(address);
    }

    /** Sends a message on the radio connection; without one there is nobody to hear it, and it is dropped. */
    void send(Layer3Message message) {
        if (!radio.isEstablished()) {
            return;
        }
        byte[] octets = Layer3Codec.encode(message, Direction.DOWNLINK, 0);
        OctetString layer3 = OctetString.of(octets);
        parts.trace().passed(this, Direction.DOWNLINK, MessageText.nameOf(message, Direction.DOWNLINK), layer3);
        RslMessage.Sapi sapi =
                message instanceof ShortMessageControl ? RslMessage.Sapi.SHORT_MESSAGES : RslMessage.Sapi.SIGNALLING;
        sendRsl(new RslMessage.DataRequest(sapi, layer3));
    }

    /** Sends what needs no radio connection: paging and cell broadcast. */
    void sendCommon(RslMessage message) {
        byte[] octets = RslCodec.encode(message);
        parts.trace().passed(this, Direction.DOWNLINK, MessageText.nameOf(message), OctetString.of(octets));
        port.send(new IpaFrame(IpaFrame.RSL, octets));
    }

    void sendCcm(CcmMessage message) {
        port.send(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }

    private void sendRsl(RslMessage message) {
        port.send(new IpaFrame(IpaFrame.RSL, RslCodec.encode(message)));
    }

    void callLegChanged(CallLeg leg) {
        if (leg.state() == NetworkCallState.NULL) {
            callLegs.remove(leg);
            paging.cancel(leg);
        } else if (!callLegs.contains(leg)) {
            callLegs.add(leg);
        }
        touched();
    }

    /** Something here has ended or begun: the exchange looks at this link again before it rests. */
    void touched() {
        parts.settlement().add(this);
    }

    /** Gives the link up. */
    void drop(String reason) {
        if (!isClosed) {
            LOG.log(hasNumber() ? Level.INFO : Level.DEBUG, "{0}: closed, {1}", this, reason);
            forget();
            port.close(reason);
        }
    }

    /** Ends this link after an error of our own, and no other. */
    void failed(RuntimeException e) {
        LOG.log(Level.ERROR, this + ": closed after an error of our own", e);
        drop("internal error");
    }

    /** The link is no more: everything on it ends, and whoever was registered here is detached. */
    void forget() {
        isClosed = true;
        keepAlive.stop();
        timers.cancel(identification);
        authenticity.cancel();
        if (registration != null) {
            registration.cancel();
        }
        radio.close();
        loseTransactions();
        parts.mobility().depart(this);
        parts.links().remove(this);
    }

    /** Counts and logs what the peer did wrong; who errs too often is given up. A babbler must not fill the log. */
    void violated(String what) {
        violations++;
        LOG.log(violations <= LOUD_VIOLATIONS ? Level.WARNING : Level.DEBUG, "{0}: {1}", this, what);
        if (violations == MAX_VIOLATIONS) {
            drop("more than " + MAX_VIOLATIONS + " breaches of protocol");
        }
    }

    /** The leg whose speech this terminal's frames are, or null. */
    CallLeg speakingLeg() {
        for (int i = 0; i < callLegs.size(); i++) {
            if (callLegs.get(i).state().speaks()) {
                return callLegs.get(i);
            }
        }
        return null;
    }

    /** Whether a further call would find the subscriber engaged. */
    boolean isInCall() {
        return callLegs.stream().anyMatch(leg -> !leg.state().isClearing());
    }

    /** Whether one call is active here and no other is known, so that a second may wait (TS 22.083). */
    boolean mayLetWait() {
        List<CallLeg> live =
                callLegs.stream().filter(leg -> !leg.state().isClearing()).toList();
        return live.size() == 1 && live.get(0).state() == NetworkCallState.ACTIVE;
    }

    /** Whether a call is over here but for its last messages. */
    boolean isClearingCall() {
        return callLegs.stream().anyMatch(leg -> leg.state().isClearing());
    }

    /** Everything that lived on the radio connection, or waited for one, ends. */
    void loseTransactions() {
        List.copyOf(callLegs).forEach(CallLeg::linkLost);
        shortMessages.lose();
    }

    @Override
    public String toString() {
        return name();
    }
}
