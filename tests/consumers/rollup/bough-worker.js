import "bough/worker-script";
