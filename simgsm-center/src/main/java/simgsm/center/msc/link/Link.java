package simgsm.center.msc.link;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Set;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.ShortMessageControl;
import simgsm.center.subscriber.Subscriber;
import simgsm.octets.OctetString;
import simgsm.timer.Timers;
import simgsm.trace.MessageText;

/** One mobile in the exchange: its subscriber, its radio connection, and its access. */
public final class Link implements Lifeline {
    /** Number of protocol errors answered by the standard's rules before the link is closed. */
    public static final int MAX_VIOLATIONS = 100;

    private static final int MAX_LOGGED_VIOLATIONS = 3;
    private static final System.Logger LOG = System.getLogger(Link.class.getName());

    private final RadioAccess access;
    private final Context context;
    private final Timers timers;
    private final NetworkRadioConnection radio;
    private final Paging paging;
    private final TerminalRateLimits rateLimits;
    private final String address;
    private Subscriber subscriber;
    private boolean isClosed;
    private String lifeline;
    private boolean hasNumber;
    private int violations;

    /**
     * The context shared by all links.
     *
     * @param open all open links
     * @param touched links to process before the exchange returns to its driver
     * @param users protocols above the links, in the order of their end after the loss of a radio connection
     */
    public record Context(Timers timers, Trace trace, Set<Link> open, Set<Link> touched, List<LinkUser> users) {}

    /**
     * A mobile that has not registered.
     *
     * @param address replaces its number until then
     * @param isLocal true if it runs on this machine, without rate limits
     */
    public Link(RadioAccess access, String address, boolean isLocal, Context context) {
        this.access = access;
        this.address = address;
        this.lifeline = address;
        this.context = context;
        this.timers = context.timers().ownedBy(this::failed);
        this.radio = new NetworkRadioConnection(this);
        this.paging = new Paging(this);
        this.rateLimits = new TerminalRateLimits(isLocal, timers);
        context.open().add(this);
    }

    /** Timers of this link; an error in one closes the link. */
    public Timers timers() {
        return timers;
    }

    public NetworkRadioConnection radio() {
        return radio;
    }

    public Paging paging() {
        return paging;
    }

    public RadioAccess access() {
        return access;
    }

    @Override
    public boolean isCiphered() {
        return access.isCiphered();
    }

    public TerminalRateLimits rateLimits() {
        return rateLimits;
    }

    public boolean isClosed() {
        return isClosed;
    }

    /** The subscriber registered here; null before the end of the location update, and after detach. */
    public Subscriber subscriber() {
        return subscriber;
    }

    public boolean hasSubscriber() {
        return subscriber != null;
    }

    /** Sets the registered subscriber. */
    public void register(Subscriber registered) {
        subscriber = registered;
        lifeline = registered.number().digits();
        hasNumber = true;
    }

    /** Sets the name on the ladder of a mobile that has not registered, after the identity in its messages. */
    public void name(String claimed) {
        if (!hasNumber) {
            lifeline = claimed;
        }
    }

    /** Removes the subscriber. */
    public void deregister() {
        subscriber = null;
    }

    /** The last number registered here, else the claimed one, or the peer's address. */
    @Override
    public String lifeline() {
        return lifeline;
    }

    /** True if a subscriber has ever registered here. */
    @Override
    public boolean hasNumber() {
        return hasNumber;
    }

    /** Sends a message on the radio connection; without one it is dropped. */
    public void send(Layer3Message message) {
        if (!radio.isEstablished()) {
            return;
        }
        OctetString layer3 = OctetString.of(Layer3Codec.encode(message, Direction.DOWNLINK, 0));
        trace(Direction.DOWNLINK, MessageText.nameOf(message, Direction.DOWNLINK), layer3);
        RslMessage.Sapi sapi =
                message instanceof ShortMessageControl ? RslMessage.Sapi.SHORT_MESSAGES : RslMessage.Sapi.SIGNALLING;
        access.send(sapi, layer3);
    }

    /** Reports a message to the operator; see {@link Trace}. */
    public void trace(Direction direction, String name, OctetString octets) {
        context.trace().passed(this, direction, name, octets);
    }

    List<LinkUser> users() {
        return context.users();
    }

    /**
     * Marks this link for processing before the exchange returns to its driver: a transaction may have released the
     * radio.
     */
    public void touch() {
        context.touched().add(this);
    }

    /** Closes the link. */
    public void drop(String reason) {
        if (!isClosed) {
            LOG.log(hasNumber() ? Level.INFO : Level.DEBUG, "{0}: closed, {1}", this, reason);
            forget();
            access.close(reason);
        }
    }

    /** Closes this link, and no other, after an internal error. */
    public void failed(RuntimeException e) {
        LOG.log(Level.ERROR, this + ": closed after an error of our own", e);
        drop("internal error");
    }

    /** Ends all transactions, and detaches the subscriber of a lost mobile. */
    public void forget() {
        if (isClosed) {
            return;
        }
        isClosed = true;
        radio.close();
        loseTransactions();
        users().forEach(user -> user.linkClosed(this));
        context.open().remove(this);
    }

    /** Counts and logs a protocol error of the peer, the first three as warnings; closes the link after the last. */
    public void violated(String what) {
        violations++;
        LOG.log(violations <= MAX_LOGGED_VIOLATIONS ? Level.WARNING : Level.DEBUG, "{0}: {1}", this, what);
        if (violations == MAX_VIOLATIONS) {
            drop(MAX_VIOLATIONS + " protocol errors");
        }
    }

    /**
     * Takes over the radio connection of a link without a subscriber, proved to be this mobile's. An older one is lost;
     * that link ends.
     */
    public void takeOver(Link provisional) {
        access.takeOver(provisional.access);
        radio.takeOver(provisional.radio);
        provisional.forget();
        touch();
    }

    /** Ends all transactions that use the radio connection or wait for one. */
    public void loseTransactions() {
        users().forEach(user -> user.radioLost(this));
    }

    /** The subscriber's number, or the peer's address without one. */
    @Override
    public String toString() {
        return subscriber == null ? address : subscriber.number().digits();
    }
}
