package simgsm.station.mobility;

import java.lang.System.Logger.Level;
import simgsm.air.Imeisv;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.MobilityManagement.AuthenticationFailure;
import simgsm.air.MobilityManagement.AuthenticationReject;
import simgsm.air.MobilityManagement.AuthenticationRequest;
import simgsm.air.MobilityManagement.AuthenticationResponse;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.IdentityRequest;
import simgsm.air.MobilityManagement.IdentityResponse;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.air.MobilityManagement.MmAbort;
import simgsm.air.MobilityManagement.MmInformation;
import simgsm.air.MobilityManagement.MmStatus;
import simgsm.air.MobilityManagement.TmsiReallocationCommand;
import simgsm.air.RejectCause;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;

/** Passes the network's mobility management messages on; answers those that only need an answer. */
public final class MobilityMessages {
    private final StationContext context;
    private final MobileRegistration registration;
    private final ServiceRequests services;
    private final Sim sim;
    private String networkName = "";

    public MobilityMessages(
            StationContext context, MobileRegistration registration, ServiceRequests services, Sim sim) {
        this.context = context;
        this.registration = registration;
        this.services = services;
        this.sim = sim;
    }

    public String networkName() {
        return networkName;
    }

    public void forgetNetwork() {
        networkName = "";
    }

    public void arrived(MobilityManagement message) {
        if (message instanceof LocationUpdatingAccept accept) {
            registration.accepted(accept);
            services.serve();
        } else if (message instanceof LocationUpdatingReject reject) {
            registration.rejected(reject.cause());
        } else if (message instanceof CmServiceAccept) {
            services.accepted();
        } else if (message instanceof CmServiceReject reject) {
            services.refused(reject.cause());
        } else if (message instanceof IdentityRequest request) {
            identify(request.identityType());
        } else if (message instanceof AuthenticationRequest request) {
            authenticate(request);
        } else if (message instanceof AuthenticationReject) {
            registration.authenticationRejected();
        } else if (message instanceof TmsiReallocationCommand command) {
            registration.reallocated(command);
        } else if (message instanceof MmAbort abort) {
            services.aborted(abort.cause());
            registration.aborted(abort.cause());
        } else if (message instanceof MmInformation information) {
            networkName = information.networkName();
            information.time().ifPresent(time -> context.events().add(new StationEvent.NetworkTimeReceived(time)));
        } else if (message instanceof MmStatus status) {
            context.log().trace(Level.INFO, "MM STATUS {0}", status.cause().title());
        } else {
            context.radio().send(new MmStatus(RejectCause.MESSAGE_TYPE_NON_EXISTENT));
        }
    }

    /** TS 24.008, 4.3.3. Without a TMSI the IMSI is sent. */
    private void identify(MobileIdentity.Type type) {
        MobileIdentity identity = switch (type) {
            case IMSI -> context.identity().imsi();
            case TMSI -> registration.identity();
            case IMEI -> context.identity().imei();
            case IMEISV -> Imeisv.of(context.identity().imei());
        };
        context.radio().send(new IdentityResponse(identity));
    }

    /** TS 24.008, 4.3.2. */
    private void authenticate(AuthenticationRequest request) {
        Sim.AuthenticationResult answer = sim.authenticate(request.rand(), request.autn());
        answer.response().ifPresent(response -> {
            registration.setKey(request.keySequence(), answer.kc().orElseThrow());
            context.radio().send(new AuthenticationResponse(response));
        });
        answer.failure().ifPresent(cause -> context.radio().send(new AuthenticationFailure(cause, answer.auts())));
    }
}
