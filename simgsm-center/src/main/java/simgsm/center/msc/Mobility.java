package simgsm.center.msc;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import simgsm.air.Imei;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.RadioResource;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.center.subscriber.Subscriber;
import simgsm.center.subscriber.SubscriberRegister;
import simgsm.octets.OctetString;
import simgsm.sim.Milenage;
import simgsm.sim.SimCard;
import simgsm.timer.Timers;

/** Mobility management of the network (TS 24.008, 4): who is attached, and at the end of which link. */
final class Mobility {
    private final SubscriberRegister register;
    private final Timers timers;
    private final RandomGenerator random;
    private final String networkName;
    private final Attachments attachments;
    private final Map<Subscriber, Link> locations = new HashMap<>();

    /** Who wants to know of coming and going. */
    interface Attachments {
        void attached(Subscriber subscriber);

        void detached(Subscriber subscriber);
    }

    Mobility(
            SubscriberRegister register,
            Timers timers,
            RandomGenerator random,
            String networkName,
            Attachments attachments) {
        this.register = register;
        this.timers = timers;
        this.random = random;
        this.networkName = networkName;
        this.attachments = attachments;
    }

    SubscriberRegister register() {
        return register;
    }

    String networkName() {
        return networkName;
    }

    Optional<Link> locationOf(Subscriber subscriber) {
        return Optional.ofNullable(locations.get(subscriber));
    }

    /** The links of all who are attached. */
    Iterable<Link> attachedLinks() {
        return locations.values();
    }

    void receive(Link link, MobilityManagement message) {
        if (message instanceof MobilityManagement.LocationUpdatingRequest request) {
            updateLocation(link, request);
        } else if (message instanceof MobilityManagement.CmServiceRequest request) {
            serve(link, request);
        } else if (message instanceof MobilityManagement.CmServiceAbort) {
            abortService(link);
        } else if (message instanceof MobilityManagement.ImsiDetachIndication indication) {
            detach(link, indication);
        } else if (message instanceof MobilityManagement.MmStatus) {
            return;
        } else if (link.authenticity.receive(message)) {
            return;
        } else if (link.registration == null || !link.registration.receive(message)) {
            link.send(new MobilityManagement.MmStatus(RejectCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE));
        }
    }

    /** Any mobile that is on the radio connection for the reason that it was paged. */
    void receivePagingResponse(Link link, RadioResource.PagingResponse response) {
        if (isSubscriberOf(link, response.identity())) {
            link.paging.answered();
        }
    }

    private void updateLocation(Link link, MobilityManagement.LocationUpdatingRequest request) {
        if (link.registration != null) {
            link.registration.cancel();
        }
        link.authenticity.cancel();
        link.registration = new LocationUpdate(link, this, link.timers);
        link.registration.start(request.identity());
    }

    private void serve(Link link, MobilityManagement.CmServiceRequest request) {
        Optional<RejectCause> refusal = refusalOf(link, request);
        if (refusal.isPresent()) {
            link.send(new MobilityManagement.CmServiceReject(refusal.get()));
            return;
        }
        Optional<SimCard> card = register.home().cardOf(link.subscriber.imsi());
        if (card.isEmpty() || link.authenticity.isFresh(request.keySequence())) {
            grant(link);
        } else {
            link.authenticity.demand(card.get(), challenge(), proven -> proved(link, proven));
        }
    }

    private void proved(Link link, boolean proven) {
        if (proven) {
            grant(link);
        } else {
            expel(link);
        }
    }

    private static void grant(Link link) {
        link.send(new MobilityManagement.CmServiceAccept());
        link.radio.awaitService();
        link.paging.answered();
    }

    /** Whoever is there now is not the one who has registered (TS 24.008, 4.3.2.5). */
    private void expel(Link link) {
        link.send(new MobilityManagement.AuthenticationReject());
        link.loseTransactions();
        depart(link);
        link.radio.release();
    }

    /** RAND. */
    OctetString challenge() {
        byte[] octets = new byte[Milenage.KEY_LENGTH];
        random.nextBytes(octets);
        return OctetString.of(octets);
    }

    private static Optional<RejectCause> refusalOf(Link link, MobilityManagement.CmServiceRequest request) {
        if (!isSubscriberOf(link, request.identity())) {
            return Optional.of(RejectCause.IMSI_UNKNOWN_IN_VLR);
        }
        if (link.authenticity.isAwaited()) {
            return Optional.of(RejectCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
        if (request.service() == MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL
                && !link.moderation.admitsCall()) {
            return Optional.of(RejectCause.CONGESTION);
        }
        return switch (request.service()) {
            case MOBILE_ORIGINATED_CALL, EMERGENCY_CALL, SHORT_MESSAGE -> Optional.empty();
            case SUPPLEMENTARY_SERVICE -> Optional.of(RejectCause.SERVICE_OPTION_NOT_SUPPORTED);
        };
    }

    private static void abortService(Link link) {
        if (link.registration == null) {
            link.authenticity.cancel();
        }
        link.radio.takeService();
    }

    private void detach(Link link, MobilityManagement.ImsiDetachIndication indication) {
        if (isSubscriberOf(link, indication.identity())) {
            if (link.registration != null) {
                link.registration.cancel();
            }
            link.authenticity.cancel();
            link.loseTransactions();
            depart(link);
        }
    }

    private static boolean isSubscriberOf(Link link, MobileIdentity identity) {
        if (link.subscriber == null) {
            return false;
        }
        return identity instanceof Tmsi tmsi
                ? link.subscriber.answersTo(tmsi)
                : link.subscriber.imsi().equals(identity);
    }

    /**
     * Whether the subscriber may register here. The same equipment replaces its own old link, which it has lost without
     * our noticing; another one is refused for as long as the old link lives.
     */
    boolean claim(Subscriber subscriber, Imei imei, Link link) {
        Link old = locations.get(subscriber);
        if (old == null || old == link) {
            return true;
        }
        if (!subscriber.imei().equals(Optional.of(imei))) {
            return false;
        }
        old.drop("the same equipment has registered " + subscriber + " on a new link");
        return true;
    }

    void attached(Subscriber subscriber, Imei imei, Link link) {
        if (link.subscriber != null && link.subscriber != subscriber) {
            depart(link);
        }
        boolean isNew = !subscriber.isAttached();
        link.become(subscriber);
        locations.put(subscriber, link);
        register.attach(subscriber, imei);
        if (isNew) {
            attachments.attached(subscriber);
        }
    }

    /** The subscriber is no longer at this link: switched off, or the link is gone. */
    void depart(Link link) {
        Subscriber gone = link.subscriber;
        if (gone == null) {
            return;
        }
        link.paging.fail();
        link.subscriber = null;
        locations.remove(gone);
        register.detach(gone);
        attachments.detached(gone);
    }
}
