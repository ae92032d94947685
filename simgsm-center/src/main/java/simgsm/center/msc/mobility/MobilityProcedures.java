package simgsm.center.msc.mobility;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.RadioResource;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.LinkUser;
import simgsm.center.subscriber.Subscriber;
import simgsm.center.subscriber.SubscriberRegister;
import simgsm.octets.OctetString;
import simgsm.sim.Milenage;
import simgsm.sim.SimCard;

/** Mobility management on the network side (TS 24.008, 4): registration, service requests, and the subscribers' locations. */
public final class MobilityProcedures implements LinkUser {
    private final SubscriberRegister register;
    private final RandomGenerator random;
    private final String networkName;
    private final Consumer<Subscriber> attached;
    private final Consumer<Subscriber> detached;
    private final Consumer<Subscriber> reachable;
    private final Map<Subscriber, Link> locations = new HashMap<>();
    private final Map<Link, LocationUpdate> updates = new HashMap<>();
    private final Map<Link, CardAuthentication> authentications = new HashMap<>();

    /**
     * @param attached is called for each subscriber who was not attached before
     * @param detached is called for each subscriber who is no longer attached
     * @param reachable is called for each attached subscriber who is heard again after a paging without an answer
     */
    public MobilityProcedures(
            SubscriberRegister register,
            RandomGenerator random,
            String networkName,
            Consumer<Subscriber> attached,
            Consumer<Subscriber> detached,
            Consumer<Subscriber> reachable) {
        this.register = register;
        this.random = random;
        this.networkName = networkName;
        this.attached = attached;
        this.detached = detached;
        this.reachable = reachable;
    }

    public SubscriberRegister register() {
        return register;
    }

    String networkName() {
        return networkName;
    }

    /** The link of an attached subscriber. */
    public Optional<Link> locationOf(Subscriber subscriber) {
        return Optional.ofNullable(locations.get(subscriber));
    }

    /** The link of an attached subscriber, by IMSI or TMSI. */
    public Optional<Link> linkOf(MobileIdentity identity) {
        Optional<Subscriber> subscriber = Optional.empty();
        if (identity instanceof Tmsi tmsi) {
            subscriber = register.ofTmsi(tmsi);
        } else if (identity instanceof Imsi imsi) {
            subscriber = register.home().numberOf(imsi).flatMap(register::ofNumber);
        }
        return subscriber.flatMap(this::locationOf);
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

    /** To be called by the update itself. */
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
            if (isSubscriberOf(link, indication.identity())) {
                link.loseTransactions();
                detach(link);
            }
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
        if (!isSubscriberOf(link, response.identity())) {
            return;
        }
        Optional<SimCard> card = register.home().cardOf(link.subscriber().imsi());
        if (card.isEmpty() || !link.access().isShared()) {
            heard(link);
        } else {
            authenticate(link, card.get(), hasKey -> {
                if (hasKey) {
                    heard(link);
                } else {
                    refuse(link);
                }
            });
        }
    }

    /** The subscriber is on a radio connection: what waits for one goes on. */
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
        Optional<RejectCause> refusal = refusalOf(link, request);
        if (refusal.isPresent()) {
            link.send(new MobilityManagement.CmServiceReject(refusal.get()));
            return;
        }
        Optional<SimCard> card = register.home().cardOf(link.subscriber().imsi());
        // Any mobile of a tower can name the identity and key number of another, which are not ciphered.
        boolean isKeyTrusted =
                !link.access().isShared() && authenticationOf(link).useKey(request.keySequence());
        if (card.isEmpty() || isKeyTrusted) {
            grant(link);
        } else {
            authenticate(link, card.get(), hasKey -> serviceAuthenticated(link, hasKey));
        }
    }

    private void serviceAuthenticated(Link link, boolean hasKey) {
        if (hasKey) {
            grant(link);
        } else {
            refuse(link);
        }
    }

    /**
     * A card without its key is not the registered one. On a terminal's own link it has taken that one's place, which is detached
     * (TS 24.008, 4.3.2.5); over towers the registered one stays attached.
     */
    private void refuse(Link link) {
        link.send(new MobilityManagement.AuthenticationReject());
        link.loseTransactions();
        if (!link.access().isShared()) {
            detach(link);
        }
        link.radio().release();
    }

    private void grant(Link link) {
        link.send(new MobilityManagement.CmServiceAccept());
        link.radio().awaitService();
        heard(link);
    }

    /** Challenges a card with a new RAND. @param ended is given whether the card has its key */
    void authenticate(Link link, SimCard card, Consumer<Boolean> ended) {
        byte[] rand = new byte[Milenage.KEY_LENGTH];
        random.nextBytes(rand);
        authenticationOf(link).begin(card, OctetString.of(rand), ended);
    }

    private Optional<RejectCause> refusalOf(Link link, MobilityManagement.CmServiceRequest request) {
        if (!isSubscriberOf(link, request.identity())) {
            return Optional.of(RejectCause.IMSI_UNKNOWN_IN_VLR);
        }
        if (authenticationOf(link).isAwaited()) {
            return Optional.of(RejectCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
        if (request.service() == MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL
                && !link.rateLimits().admitCall()) {
            return Optional.of(RejectCause.CONGESTION);
        }
        return Optional.empty();
    }

    private void abortService(Link link) {
        if (!updates.containsKey(link)) {
            authenticationOf(link).cancel();
        }
        link.radio().takeService();
    }

    private static boolean isSubscriberOf(Link link, MobileIdentity identity) {
        if (!link.hasSubscriber()) {
            return false;
        }
        return identity instanceof Tmsi tmsi
                ? link.subscriber().answersTo(tmsi)
                : link.subscriber().imsi().equals(identity);
    }

    /**
     * Whether the subscriber may register on this link. The same equipment replaces its own old link; another one is
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

    /** A mobile of towers updates its location on a new radio connection: it stays attached. */
    private void move(Subscriber subscriber, Link old) {
        old.deregister();
        locations.remove(subscriber);
        old.drop(subscriber + " has updated its location");
    }

    void attached(Subscriber subscriber, Imei imei, Link link) {
        if (link.subscriber() != subscriber) {
            detach(link);
        }
        boolean isNew = !subscriber.isAttached();
        link.register(subscriber);
        locations.put(subscriber, link);
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
            locations.remove(subscriber);
            register.detach(subscriber);
            detached.accept(subscriber);
        }
    }
}
