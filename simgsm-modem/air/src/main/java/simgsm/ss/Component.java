package simgsm.ss;

import java.util.Optional;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;

/** One component of a facility element (TS 24.080, 3.6.1): a request of one side, or the answer. */
public sealed interface Component {
    /**
     * Requests an operation.
     *
     * @param id invoke identifier, 0 to 127, repeated in the answer
     * @param operation see {@link SsOperation}
     * @param argument the parameter in BER; empty if there is none
     */
    record Invoke(int id, int operation, OctetString argument) implements Component {
        public Invoke {
            checkId(id);
            Bounds.checkOctet("operation code", operation);
        }

        public Invoke(int id, SsOperation operation, OctetString argument) {
            this(id, operation.code(), argument);
        }

        /** True if the component requests this operation. */
        public boolean is(SsOperation expected) {
            return operation == expected.code();
        }
    }

    /**
     * The operation has succeeded.
     *
     * @param operation empty if there is no result
     * @param result the parameter in BER; empty if there is none
     */
    record ReturnResult(int id, Optional<Integer> operation, OctetString result) implements Component {
        public ReturnResult {
            checkId(id);
        }

        /** The result of an operation. */
        public ReturnResult(int id, SsOperation operation, OctetString result) {
            this(id, Optional.of(operation.code()), result);
        }

        /** A success without a result. */
        public ReturnResult(int id) {
            this(id, Optional.empty(), NONE);
        }
    }

    /** The operation has failed. @param error see {@link SsError} */
    record ReturnError(int id, int error) implements Component {
        public ReturnError {
            checkId(id);
            Bounds.checkOctet("error code", error);
        }

        public ReturnError(int id, SsError error) {
            this(id, error.code());
        }
    }

    /** The component breaks the protocol. @param id empty if it could not be read */
    record Reject(Optional<Integer> id, SsProblem problem) implements Component {
        public Reject {
            id.ifPresent(Component::checkId);
        }
    }

    /** No parameter. */
    OctetString NONE = OctetString.of(new byte[0]);

    private static void checkId(int id) {
        Bounds.check("invoke identifier", id, 0, 0x7f);
    }
}
