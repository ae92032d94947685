package simgsm.center.msc.mobility;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import simgsm.air.Imei;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.RadioResource;
import simgsm.air.RejectCause;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.LinkUser;
import simgsm.center.subscriber.Subscriber;
import simgsm.center.subscriber.SubscriberRegister;
import simgsm.octets.OctetString;
import simgsm.sim.Milenage;
import simgsm.sim.SimCard;
import simgsm.timer.Timer;

/** Mobility management on the network side (TS 24.008, 4): registration, service requests, and the subscribers' locations. */
public final class MobilityProcedures implements LinkUser {
    private final SubscriberRegister register;
    private final RandomGenerator random;
    private final Supplier<MobilityManagement.MmInformation> information;
    private final Consumer<Subscriber> attached;
    private final Consumer<Subscriber> detached;
    private final Consumer<Subscriber> reachable;
    private final Map<Subscriber, Link> locations = new HashMap<>();
    /** Timers of subscribers over towers; see {@link #detachSilentAfter}. */
    private final Map<Subscriber, Timer> silences = new HashMap<>();

    private final Map<Link, LocationUpdate> updates = new HashMap<>();
    private final Map<Link, CardAuthentication> authentications = new HashMap<>();
    private long silenceNanos;

    /**
     * @param information name and time for a newly registered mobile
     * @param attached called when a subscriber attaches
     * @param detached called when a subscriber is detached
     * @param reachable called when an attached subscriber sends a message after an unanswered paging
     */
    public MobilityProcedures(
            SubscriberRegister register,
            RandomGenerator random,
            Supplier<MobilityManagement.MmInformation> information,
            Consumer<Subscriber> attached,
            Consumer<Subscriber> detached,
            Consumer<Subscriber> reachable) {
        this.register = register;
        this.random = random;
        this.information = information;
        this.attached = attached;
        this.detached = detached;
        this.reachable = reachable;
    }

    public SubscriberRegister register() {
        return register;
    }

    MobilityManagement.MmInformation information() {
        return information.get();
    }

    /** The link of an attached subscriber. */
    public Optional<Link> locationOf(Subscriber subscriber) {
        return Optional.ofNullable(locations.get(subscriber));
    }

    /** The link of an attached subscriber, by IMSI or TMSI. */
    public Optional<Link> linkOf(MobileIdentity identity) {
        return register.ofIdentity(identity).flatMap(this::locationOf);
    }

    /** The links of all attached subscribers. */
    public Iterable<Link> attachedLinks() {
        return locations.values();
    }

    @Override
    public boolean needsRadio(Link link) {
        return updates.containsKey(link) || authenticationOf(link).isAwaited();
    }

    @Override
    public boolean reservesRadio(Link link) {
        return updates.containsKey(link);
    }

    @Override
    public void radioLost(Link link) {
        cancelUpdate(link);
        authenticationOf(link).cancel();
    }

    @Override
    public void linkClosed(Link link) {
        detach(link);
        authentications.remove(link);
    }

    private CardAuthentication authenticationOf(Link link) {
        return authentications.computeIfAbsent(link, CardAuthentication::new);
    }

    private void cancelUpdate(Link link) {
        LocationUpdate update = updates.get(link);
        if (update != null) {
            update.cancel();
        }
    }

    void updateEnded(Link link) {
        updates.remove(link);
        authenticationOf(link).cancel();
    }

    public void receive(Link link, MobilityManagement message) {
        if (message instanceof MobilityManagement.LocationUpdatingRequest request) {
            updateLocation(link, request);
        } else if (message instanceof MobilityManagement.CmServiceRequest request) {
            serve(link, request);
        } else if (message instanceof MobilityManagement.CmServiceAbort) {
            abortService(link);
        } else if (message instanceof MobilityManagement.ImsiDetachIndication indication) {
            namedBy(link, indication.identity()).ifPresent(named -> {
                if (named == link) {
                    leave(link);
                } else {
                    prove(link, named.subscriber(), this::leave);
                }
            });
        } else if (!(message instanceof MobilityManagement.MmStatus)
                && !authenticationOf(link).receive(message)
                && !(updates.containsKey(link) && updates.get(link).receive(message))) {
            link.send(new MobilityManagement.MmStatus(RejectCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE));
        }
    }

    /** An IDENTITY RESPONSE could not be decoded. */
    public void identityInvalid(Link link) {
        if (updates.containsKey(link)) {
            updates.get(link).identityInvalid();
        }
    }

    /** The mobile has answered paging. */
    public void receivePagingResponse(Link link, RadioResource.PagingResponse response) {
        namedBy(link, response.identity()).ifPresent(named -> {
            if (mustProve(named)) {
                prove(link, named.subscriber(), this::heard);
            } else {
                heard(link);
            }
        });
    }

    // Radio connections over towers, on which any mobile can name the identity of another.

    /** True if a radio connection that names the subscriber of this link has to prove it with the card's key. */
    public boolean mustProve(Link link) {
        return link.access().isShared() && cardOf(link.subscriber()).isPresent();
    }

    private Optional<SimCard> cardOf(Subscriber subscriber) {
        return register.home().cardOf(subscriber.imsi());
    }

    /**
     * The link of the subscriber named in a message: this one, or one over towers that the mobile may prove to be its
     * own.
     */
    private Optional<Link> namedBy(Link link, MobileIdentity identity) {
        if (link.hasSubscriber() && link.subscriber().isNamed(identity)) {
            return Optional.of(link);
        }
        boolean isUnproved = link.access().isShared() && !link.hasSubscriber();
        return isUnproved ? linkOf(identity).filter(this::mustProve) : Optional.empty();
    }

    /**
     * Challenges the mobile on a link. One with the key continues with the link of its subscriber, which is unchanged
     * until then, with its connection and paging.
     */
    private void prove(Link link, Subscriber subscriber, Consumer<Link> proved) {
        authenticate(link, cardOf(subscriber).orElseThrow(), hasKey -> {
            Optional<Link> own = locationOf(subscriber).filter(found -> found == link || mustProve(found));
            if (!hasKey) {
                refuse(link);
            } else if (own.isEmpty()) {
                // detached meanwhile
                link.radio().release();
            } else {
                if (own.get() != link) {
                    own.get().takeOver(link);
                }
                proved.accept(own.get());
            }
        });
    }

    /**
     * Handles IMSI DETACH of the link's subscriber. The standard requires no proof (TS 24.008, 4.3.4), but permits one
     * on each connection (4.3.2.2).
     */
    private void leave(Link link) {
        link.loseTransactions();
        detach(link);
    }

    /** Sets the silence after which a subscriber over towers is detached (TS 24.008, 4.4.2); 0 for never. */
    public void detachSilentAfter(long nanos) {
        silenceNanos = nanos;
    }

    private void superviseSilence(Link link, Subscriber subscriber, long nanos) {
        Timer silence = link.timers().start(nanos, () -> {
            long silent = link.radio().isIdle()
                    ? link.timers().nowNanos() - link.radio().usedNanos()
                    : 0;
            if (silent >= silenceNanos) {
                link.drop(subscriber + " has not been heard since its last periodic location update");
            } else {
                superviseSilence(link, subscriber, silenceNanos - silent);
            }
        });
        silences.put(subscriber, silence);
    }

    private void leaveLocation(Subscriber subscriber, Link link) {
        locations.remove(subscriber);
        link.timers().cancel(silences.remove(subscriber));
    }

    /** Continues the waiting transactions of a subscriber with a radio connection. */
    private void heard(Link link) {
        boolean wasSilent = link.paging().isUnanswered();
        link.paging().answered();
        if (wasSilent) {
            reachable.accept(link.subscriber());
        }
    }

    private void updateLocation(Link link, MobilityManagement.LocationUpdatingRequest request) {
        cancelUpdate(link);
        authenticationOf(link).cancel();
        LocationUpdate update = new LocationUpdate(link, this);
        updates.put(link, update);
        update.start(request.identity());
    }

    private void serve(Link link, MobilityManagement.CmServiceRequest request) {
        if (EmergencyCalls.isAskedBy(request)
                && namedBy(link, request.identity()).isEmpty()) {
            EmergencyCalls.admit(link, request.identity());
            return;
        }
        Optional<RejectCause> refusal = refusalOf(link, request);
        if (refusal.isPresent()) {
            link.send(new MobilityManagement.CmServiceReject(refusal.get()));
            return;
        }
        Link named = namedBy(link, request.identity()).orElseThrow();
        // over towers a mobile can learn another's identity and key number, because requests are not ciphered
        boolean isKeyTrusted = !mustProve(named) && authenticationOf(link).useKey(request.keySequence());
        if (isKeyTrusted || cardOf(named.subscriber()).isEmpty()) {
            admit(link, request, false);
        } else {
            CardAuthentication proof = authenticationOf(link);
            prove(link, named.subscriber(), own -> admit(own, request, proof.beganToCipher()));
        }
    }

    /**
     * Refuses a card without its key, which is not the registered one. On a terminal's link it has replaced that one,
     * which is detached (TS 24.008, 4.3.2.5); over towers the registered one stays attached.
     */
    private void refuse(Link link) {
        link.send(new MobilityManagement.AuthenticationReject());
        link.loseTransactions();
        if (!link.access().isShared()) {
            detach(link);
        }
        link.radio().release();
    }

    private void admit(Link link, MobilityManagement.CmServiceRequest request, boolean isAcceptedByCiphering) {
        boolean isCall = request.service() == MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL;
        if (EmergencyCalls.isAskedBy(request)) {
            EmergencyCalls.admit(link, request.identity());
        } else if (isCall && !link.rateLimits().admitCall()) {
            link.send(new MobilityManagement.CmServiceReject(RejectCause.CONGESTION));
            if (isAcceptedByCiphering) {
                link.radio().release();
            }
            return;
        } else {
            if (!isAcceptedByCiphering) {
                link.send(new MobilityManagement.CmServiceAccept());
            }
            link.radio().awaitService();
        }
        heard(link);
    }

    /**
     * Challenges a card with a new RAND.
     *
     * @param ended receives true if the card has its key
     */
    void authenticate(Link link, SimCard card, Consumer<Boolean> ended) {
        byte[] rand = new byte[Milenage.KEY_LENGTH];
        random.nextBytes(rand);
        authenticationOf(link).begin(card, OctetString.of(rand), ended);
    }

    private Optional<RejectCause> refusalOf(Link link, MobilityManagement.CmServiceRequest request) {
        if (namedBy(link, request.identity()).isEmpty()) {
            return Optional.of(RejectCause.IMSI_UNKNOWN_IN_VLR);
        }
        if (authenticationOf(link).isAwaited()) {
            return Optional.of(RejectCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
        return Optional.empty();
    }

    private void abortService(Link link) {
        if (!updates.containsKey(link)) {
            authenticationOf(link).cancel();
        }
        link.radio().takeService();
    }

    /**
     * True if the subscriber may register on this link. The same equipment replaces its old link; another one is
     * refused while the old link is open.
     */
    boolean claim(Subscriber subscriber, Imei imei, Link link) {
        Link old = locations.get(subscriber);
        if (old == null || old == link) {
            return true;
        }
        boolean isSameEquipment = subscriber.imei().equals(Optional.of(imei));
        if (!isSameEquipment && !old.paging().isUnanswered()) {
            return false;
        }
        if (isSameEquipment && old.access().isShared()) {
            move(subscriber, old);
            reachable.accept(subscriber);
            return true;
        }
        old.drop("the same equipment has registered " + subscriber + " on a new link");
        return true;
    }

    /** Moves a mobile of towers to its new radio connection; it stays attached. */
    private void move(Subscriber subscriber, Link old) {
        old.deregister();
        leaveLocation(subscriber, old);
        old.drop(subscriber + " has updated its location");
    }

    void attached(Subscriber subscriber, Imei imei, Link link) {
        if (link.subscriber() != subscriber) {
            detach(link);
        }
        boolean isNew = !subscriber.isAttached();
        link.register(subscriber);
        boolean isNewHere = locations.put(subscriber, link) != link;
        if (isNewHere && link.access().isShared() && silenceNanos > 0) {
            superviseSilence(link, subscriber, silenceNanos);
        }
        register.attach(subscriber, imei);
        if (isNew) {
            attached.accept(subscriber);
        }
    }

    /** Detaches the subscriber of a link, if there is one. */
    void detach(Link link) {
        if (link.hasSubscriber()) {
            Subscriber subscriber = link.subscriber();
            link.paging().fail();
            link.deregister();
            leaveLocation(subscriber, link);
            register.detach(subscriber);
            detached.accept(subscriber);
        }
    }
}
