package simgsm.center.msc.ss;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import simgsm.air.Cause;
import simgsm.air.ProtocolViolation;
import simgsm.air.SupplementaryService;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.Link;
import simgsm.ss.Component;
import simgsm.ss.Component.Invoke;
import simgsm.ss.Component.Reject;
import simgsm.ss.Component.ReturnError;
import simgsm.ss.ComponentCodec;
import simgsm.ss.ComponentFault;
import simgsm.ss.SsError;
import simgsm.ss.SsOperation;
import simgsm.ss.SsProblem;
import simgsm.ss.UssdText;

/** The USSD dialogues of one link: the mobile's, and at most one that the network began. */
final class LinkDialogues {
    private static final int TRANSACTIONS = 7;

    private final Link link;
    private final BiConsumer<UssdSession, String> services;
    private final ServiceProcedures procedures;
    private final List<UssdDialogue> ofMobile = new ArrayList<>(1);
    /** Changes requested by the mobile that are being stored before the answer. */
    private final List<SsRegister> storing = new ArrayList<>(1);

    private UssdDialogue ofNetwork;
    private int nextTransaction;

    /** @param services receives each dialogue that the mobile begins, with its code */
    LinkDialogues(Link link, BiConsumer<UssdSession, String> services, ServiceProcedures procedures) {
        this.link = link;
        this.procedures = procedures;
        this.services = services;
    }

    boolean needRadio() {
        return !ofMobile.isEmpty() || !storing.isEmpty() || ofNetwork != null && ofNetwork.needsRadio();
    }

    /** Ends all dialogues of a lost mobile. */
    void closed() {
        storing.clear();
    }

    void radioLost() {
        storing.clear();
        List.copyOf(ofMobile).forEach(UssdDialogue::radioLost);
        if (ofNetwork != null) {
            ofNetwork.radioLost();
        }
    }

    /**
     * Asks the mobile a question, after paging if necessary; an open dialogue with the same question is shared.
     *
     * @param told receives the outcome, once
     */
    void ask(String question, Consumer<UssdOutcome> told) {
        if (ofNetwork != null) {
            if (!ofNetwork.join(question, told)) {
                told.accept(UssdOutcome.of(UssdOutcome.Kind.BUSY));
            }
            return;
        }
        TransactionIdentifier transaction = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        ofNetwork = UssdDialogue.ofNetwork(link, transaction, question, told, this::ended);
        link.paging().request(ofNetwork);
    }

    void receive(SupplementaryService message) {
        TransactionIdentifier transaction = message.transaction().answered();
        Optional<UssdDialogue> dialogue = dialogue(transaction);
        if (message instanceof SsRegister register && dialogue.isEmpty()) {
            register(register, transaction);
        } else if (message instanceof SsReleaseComplete release) {
            dialogue.ifPresent(known -> known.receive(release));
        } else if (message instanceof SsFacility facility && dialogue.isPresent()) {
            dialogue.get().receive(facility);
        } else {
            link.send(new SsReleaseComplete(transaction, Cause.INVALID_TRANSACTION_IDENTIFIER));
        }
    }

    private Optional<UssdDialogue> dialogue(TransactionIdentifier transaction) {
        if (ofNetwork != null && ofNetwork.transaction().equals(transaction)) {
            return Optional.of(ofNetwork);
        }
        return ofMobile.stream()
                .filter(dialogue -> dialogue.transaction().equals(transaction))
                .findFirst();
    }

    private void register(SsRegister register, TransactionIdentifier transaction) {
        if (!transaction.fromOtherSide() || !link.radio().takeService()) {
            link.send(new SsReleaseComplete(transaction, Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE));
            return;
        }
        try {
            Component component = ComponentCodec.decode(register.facility());
            if (!perform(register, component, transaction)) {
                begin(component, transaction).ifPresent(last -> end(transaction, last));
            }
        } catch (ComponentFault fault) {
            link.violated(fault.getMessage());
            link.send(new SsReleaseComplete(transaction, ComponentCodec.encode(fault.answer())));
        }
    }

    /**
     * Performs an operation on a supplementary service.
     *
     * @return false if it is none
     */
    private boolean perform(SsRegister register, Component component, TransactionIdentifier transaction) {
        if (!(component instanceof Invoke invoke)) {
            return false;
        }
        storing.add(register);
        boolean isPerformed = procedures.perform(link.subscriber(), invoke, last -> {
            if (storing.remove(register)) {
                end(transaction, last);
                link.touch();
            }
        });
        if (!isPerformed) {
            storing.remove(register);
        }
        return isPerformed;
    }

    private void end(TransactionIdentifier transaction, Component last) {
        link.send(new SsReleaseComplete(transaction, ComponentCodec.encode(last)));
    }

    /** @return the reason of a refusal */
    private Optional<Component> begin(Component component, TransactionIdentifier transaction) {
        if (!(component instanceof Invoke invoke)) {
            return Optional.of(new Reject(Optional.empty(), SsProblem.UNRECOGNIZED_COMPONENT));
        }
        if (!invoke.is(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST)) {
            return Optional.of(
                    SsOperation.ofCode(invoke.operation()).isPresent()
                            ? new ReturnError(invoke.id(), SsError.FACILITY_NOT_SUPPORTED)
                            : new Reject(Optional.of(invoke.id()), SsProblem.UNRECOGNIZED_OPERATION));
        }
        if (!link.rateLimits().admitMessage()) {
            return Optional.of(new Reject(Optional.of(invoke.id()), SsProblem.RESOURCE_LIMITATION));
        }
        String code;
        try {
            code = UssdText.decode(invoke.argument()).text();
        } catch (ProtocolViolation violation) {
            link.violated(violation.getMessage());
            return Optional.of(new Reject(Optional.of(invoke.id()), SsProblem.MISTYPED_PARAMETER));
        }
        UssdDialogue begun = UssdDialogue.ofMobile(link, transaction, invoke, this::ended);
        ofMobile.add(begun);
        services.accept(begun, code);
        return Optional.empty();
    }

    private void ended(UssdDialogue dialogue) {
        if (dialogue == ofNetwork) {
            ofNetwork = null;
        } else {
            ofMobile.remove(dialogue);
        }
        link.touch();
    }
}
